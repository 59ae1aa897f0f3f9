// What a client link reads, writes and reports, pass by pass in fake time.
#include "symplant/link/client/session.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "symplant/link/client/reconnection.hpp"
#include "symplant/link/modbus/client_settings.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/link/slmp/settings.hpp"
#include "unit/exec/cell.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using link::LinkFinding;
using link::client::ClientTimes;
using link::client::Dialog;
using link::client::Fault;
using link::client::LaneChange;
using link::client::Unwritten;
using tables::FindingKind;
using test::SymbolList;

namespace {

constexpr std::uint16_t kCode = 0xC056;

/// A PLC with one word of inputs, without a connection.
class FakePlc final : public Dialog {
 public:
  std::uint16_t inputs = 0;
  std::uint16_t refused = 0;  ///< a request that writes one of these is refused
  std::uint16_t busy = 0;     ///< for these once
  std::uint64_t writes = 0;

  std::string url() const override { return "fake:"; }
  Fault open() override { return {}; }
  void close() noexcept override {}
  link::client::Identity identify(Fault& /*fault*/) override { return {link::client::Identity::Kind::verified, "CPU"}; }
  Fault read(const link::client::Words& /*operations*/, tables::Time /*now*/) override { return {}; }
  Fault write(std::span<const LaneChange> changes, std::vector<Unwritten>& unwritten) override {
    for (const LaneChange& change : changes) {
      ++writes;
      const tables::Refusal refusal{tables::Refusal::Side::slmp_client, 0, kCode, 7};
      if ((change.mask & refused) != 0) {
        unwritten.push_back({change, link::client::Answer::refused, refusal});
        rejections_.push_back({link::client::Answer::refused, refusal, "refused"});
      } else if ((change.mask & std::exchange(busy, 0)) != 0) {
        unwritten.push_back({change, link::client::Answer::busy, refusal});
      } else {
        inputs = static_cast<std::uint16_t>((inputs & ~change.mask) | (change.value & change.mask));
      }
    }
    return {};
  }
  Fault read_back(const link::client::Words& events, tables::Time /*now*/) override {
    events.bits[0] = inputs;
    return {};
  }
  void observe(link::client::ReadObserver* /*observer*/) noexcept override {}
  void retry_rejected() noexcept override {}
  bool is_dividing() const noexcept override { return false; }
  std::vector<link::client::Rejection> take_rejections() override { return std::exchange(rejections_, {}); }
  std::vector<link::client::LeftOut> take_left_out() override { return {}; }
  void interrupt() noexcept override {}
  std::uint64_t requests() const noexcept override { return 0; }
  std::uint64_t rejected() const noexcept override { return 0; }

 private:
  std::vector<link::client::Rejection> rejections_;
};

SymbolList four_events() {
  SymbolList list;
  for (std::uint32_t i = 0; i < 4; ++i) list.add("I" + std::to_string(i), SymbolList::kIn, i);
  return list;
}

/// A session with the FakePlc, whose events are all off.
class SessionBench {
 public:
  explicit SessionBench(const ClientTimes& times)
      : times_(times),
        tables_(list_.tables()),
        map_(image_of(tables_, link::modbus::make_io_map(tables_, 0, {.status_block = link::kNowhere}))),
        plant_(tables_),
        images_(tables_, map_),
        session_(plc, tables_, map_, times, images_, false) {
    images_.write_events(*plant_);
    REQUIRE_FALSE(session_.begin(now_));
  }

  FakePlc plc;

  /// Passes for this long; `between` runs before each.
  void run(
      tables::Time duration, const std::function<void()>& between = [] {}) {
    for (const tables::Time end = now_ + duration; now_ < end; now_ += times_.poll) {
      between();
      REQUIRE_FALSE(session_.pass(now_, 0, false));
      while (const auto finding = session_.take_finding()) found.push_back(*finding);
    }
  }
  std::size_t count(FindingKind kind, std::uint32_t symbol) const {
    return static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [&](const LinkFinding& finding) {
      return finding.kind == kind && finding.symbol == symbol;
    }));
  }

  std::vector<LinkFinding> found;

 private:
  ClientTimes times_;
  SymbolList list_ = four_events();
  tables::PlantTables tables_;
  link::image::Map map_;
  test::OwnedPlant plant_;
  link::image::Images images_;
  tables::Time now_ = 0;
  link::client::Session session_;
};

const std::vector<ClientTimes> kDefaults = {link::slmp::Settings().times, link::modbus::ClientSettings().times};

}  // namespace

TEST_CASE("An event that the PLC overwrites is reported with the default times of each protocol") {
  for (const ClientTimes& times : kDefaults) {
    SessionBench bench(times);
    bench.run(30 * tables::kSecond, [&] { bench.plc.inputs |= 4; });
    CHECK(bench.count(FindingKind::event_overwritten, 2) == 1);
    CHECK(bench.found.size() == 1);
  }
}

TEST_CASE("An event that the PLC overwrites is reported whatever the times are") {
  for (const tables::Time refresh : {10, 50, 100, 150, 200, 1000, 1010, 3000}) {
    for (const tables::Time read_back : {10, 20, 100, 200, 1000}) {
      CAPTURE(refresh, read_back);
      SessionBench bench({.refresh = refresh * tables::kMillisecond, .read_back = read_back * tables::kMillisecond});
      bench.run(10 * tables::kSecond, [&] { bench.plc.inputs |= 4; });
      CHECK(bench.count(FindingKind::event_overwritten, 2) == 1);
      CHECK(bench.found.size() == 1);
    }
  }
}

TEST_CASE("One difference of an event is corrected and not reported") {
  SessionBench bench(kDefaults.front());
  bench.run(1500 * tables::kMillisecond);
  bench.plc.inputs = 2;
  bench.run(10 * tables::kSecond);
  CHECK(bench.plc.inputs == 0);
  CHECK(bench.found.empty());
}

TEST_CASE("An event that the PLC refuses is left out, reported, and tried again, the others are written") {
  SessionBench bench(kDefaults.front());
  bench.plc.refused = 2;
  bench.plc.inputs = 0xF;
  bench.run(tables::kSecond);
  CHECK(bench.plc.inputs == 2);
  CHECK(bench.count(FindingKind::request_refused, tables::kNone) == 1);
  CHECK(bench.found.front().value == tables::pack({tables::Refusal::Side::slmp_client, 0, kCode, 7}));
  CHECK(bench.count(FindingKind::symbol_left_out, 1) == 0);
  bench.run(10 * tables::kSecond);
  CHECK(bench.count(FindingKind::symbol_left_out, 1) == 1);
  CHECK(bench.found.size() == 2);
  CHECK(bench.found.back().value == bench.found.front().value);
  const std::uint64_t before = bench.plc.writes;
  bench.run(60 * tables::kSecond);
  CHECK(bench.plc.writes - before < 5 + 2 * 30);  // the refreshes, and few of the refused one
  bench.plc.refused = 0;
  bench.run(31 * tables::kSecond);
  CHECK(bench.plc.inputs == 0);
}

TEST_CASE("An event that the PLC was too busy for is written in the next pass") {
  SessionBench bench(kDefaults.front());
  bench.plc.inputs = 0xF;
  bench.plc.busy = 2;
  bench.run(2 * kDefaults.front().poll);
  CHECK(bench.plc.inputs == 0);
  CHECK(bench.found.empty());
}

TEST_CASE("The pause before a new connection grows while connections end early, and after failures") {
  link::client::Reconnection reconnection({.poll = 10, .first_retry = 100, .last_retry = 1000});
  std::vector<tables::Time> pauses;
  for (int i = 0; i < 7; ++i) pauses.push_back(reconnection.after_exchange(tables::kSecond));
  CHECK(pauses == std::vector<tables::Time>{0, 10, 20, 40, 80, 100, 100});
  CHECK(reconnection.after_exchange(link::client::Reconnection::kEarly) == 0);
  CHECK(reconnection.after_exchange(tables::kSecond) == 0);
  pauses.clear();
  for (int i = 0; i < 6; ++i) pauses.push_back(reconnection.after_failure());
  CHECK(pauses == std::vector<tables::Time>{100, 200, 400, 800, 1000, 1000});
}
