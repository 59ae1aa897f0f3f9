// Reading at a fixed interval, with a dialog and a clock that the tests move.
#include "symplant/link/record/read_loop.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using link::client::Fault;
using link::client::LaneChange;
using link::client::Unwritten;
using tables::kMillisecond;
using tables::Time;
using test::SymbolList;

namespace {

/// Only a request and a sleep take time. The loop ends at `end`.
class FakeClock final : public link::record::LoopClock {
 public:
  Time now() override { return time; }
  bool sleep_until(Time until) override {
    sleeps.push_back(until);
    time = std::max(time, until);
    return time < end;
  }

  Time time = 1000 * kMillisecond;
  Time end = tables::kNever;
  std::vector<Time> sleeps;
};

/// Has one request for operations and one for events, which take `request_time` each.
class PolledPlc final : public link::client::Dialog {
 public:
  explicit PolledPlc(FakeClock& clock) : clock_(clock) {}

  Time request_time = 2 * kMillisecond;
  std::function<void(PolledPlc&)> before_image = [](PolledPlc& /*plc*/) {};
  bool operation = false;
  bool event = false;
  bool refuses_events = false;
  bool fails = false;
  bool refuses_connections = false;
  int images = 0;
  int opened = 0;
  int writes = 0;

  std::string url() const override { return "fake:"; }
  Fault open() override {
    ++opened;
    if (!refuses_connections) return {};
    return {Fault::Kind::transport, "no connection"};
  }
  void close() noexcept override {}
  link::client::Identity identify(Fault& /*fault*/) override { return {link::client::Identity::Kind::verified, "CPU"}; }
  Fault read(const link::client::Words& operations, Time /*now*/) override {
    ++images;
    before_image(*this);
    if (fails) return {Fault::Kind::transport, "connection lost"};
    link::image::set_bit(operations.bits, 0, operation);
    answer();
    return {};
  }
  Fault read_back(const link::client::Words& events, Time /*now*/) override {
    if (refuses_events) {
      rejections_.push_back({link::client::Answer::refused, {}, "the PLC refuses to read events"});
      return {Fault::Kind::rejected};
    }
    link::image::set_bit(events.bits, 0, event);
    answer();
    return {};
  }
  Fault write(std::span<const LaneChange> /*changes*/, std::vector<Unwritten>& /*unwritten*/) override {
    ++writes;
    return {};
  }
  void observe(link::client::ReadObserver* observer) noexcept override { observer_ = observer; }
  void retry_rejected() noexcept override {}
  bool is_dividing() const noexcept override { return false; }
  std::vector<link::client::Rejection> take_rejections() override { return std::exchange(rejections_, {}); }
  std::vector<link::client::LeftOut> take_left_out() override { return {}; }
  void interrupt() noexcept override {}
  std::uint64_t requests() const noexcept override { return 0; }
  std::uint64_t rejected() const noexcept override { return 0; }

 private:
  void answer() {
    const Time sent = clock_.time;
    clock_.time += request_time;
    link::image::set_bit(observer_->marks().bits, 0, true);
    observer_->answered(sent, clock_.time);
  }

  FakeClock& clock_;
  link::client::ReadObserver* observer_ = nullptr;
  std::vector<link::client::Rejection> rejections_;
};

struct Taken {
  Time operation_time;
  Time event_time;
  bool operation;
  bool event;
  bool event_is_read;
  bool reconnected;
};

/// A loop over an operation O and an event I.
class LoopBench final : public link::record::ImageSink {
 public:
  LoopBench() : plc_(std::make_unique<PolledPlc>(clock)), plc(*plc_) {
    list_.add("O", SymbolList::kOut, 0);
    list_.add("I", SymbolList::kIn, 0);
  }

  void run(Time every, Time duration) {
    const tables::PlantTables tables = list_.tables();
    link::LinkSettings settings;
    settings.status_block = link::kNowhere;
    link::client::ClientParts parts{.dialog = std::move(plc_),
                                    .map = image_of(tables, link::modbus::make_io_map(tables, 0, settings)),
                                    .addresses = {},
                                    .word_orders = {},
                                    .unreachable = {},
                                    .times = {},
                                    .notes = {}};
    clock.end = clock.time + duration;
    link::record::ReadLoop(parts, tables, every, clock, *this, meter).run();
    plc_ = std::unique_ptr<PolledPlc>(static_cast<PolledPlc*>(parts.dialog.release()));
  }

  void image(const link::record::Image& image) override {
    const auto& operation = image.readings[0];
    const auto& event = image.readings[1];
    taken.push_back(
        {operation.time, event.time, operation.value != 0, event.value != 0, event.is_read, image.reconnected});
  }
  void lost() override { ++losses; }
  void message(std::string text) override { messages.push_back(std::move(text)); }

  bool says(const std::string& text) const {
    return std::any_of(messages.begin(), messages.end(),
                       [&](const std::string& message) { return message.find(text) != std::string::npos; });
  }

  FakeClock clock;

 private:
  SymbolList list_;
  std::unique_ptr<PolledPlc> plc_;

 public:
  PolledPlc& plc;
  link::record::LoopMeter meter;
  std::vector<Taken> taken;
  std::vector<std::string> messages;
  int losses = 0;
};

}  // namespace

TEST_CASE("A symbol has the middle between its request and the answer, each request its own") {
  LoopBench bench;
  bench.run(50 * kMillisecond, 120 * kMillisecond);
  REQUIRE(bench.taken.size() == 3);
  const Time begin = 1000 * kMillisecond;
  CHECK(bench.taken[0].operation_time == begin + 1 * kMillisecond);
  CHECK(bench.taken[0].event_time == begin + 3 * kMillisecond);
  CHECK(bench.taken[2].operation_time == begin + 101 * kMillisecond);
  CHECK(bench.taken[2].event_time == begin + 103 * kMillisecond);
}

TEST_CASE("Images begin on a fixed grid, whatever they take") {
  LoopBench bench;
  bench.plc.before_image = [](PolledPlc& plc) { plc.request_time = (plc.images % 7 + 1) * 3 * kMillisecond; };
  bench.run(50 * kMillisecond, 2'000 * kMillisecond);
  REQUIRE(bench.taken.size() == 40);
  for (std::size_t i = 0; i < bench.clock.sleeps.size(); ++i) {
    CHECK(bench.clock.sleeps[i] == static_cast<Time>(1050 + 50 * i) * kMillisecond);
  }
  CHECK(bench.meter.late.value() == 0);
}

TEST_CASE("After an image that took longer the next one begins at once, and is counted") {
  LoopBench bench;
  bench.plc.before_image = [](PolledPlc& plc) { plc.request_time = (plc.images == 2 ? 60 : 1) * kMillisecond; };
  bench.run(50 * kMillisecond, 400 * kMillisecond);
  CHECK(bench.meter.late.value() == 1);
  REQUIRE(bench.taken.size() > 4);
  CHECK(bench.taken[1].operation_time == (1050 + 30) * kMillisecond);
  CHECK(bench.taken[2].operation_time == (1050 + 120) * kMillisecond + kMillisecond / 2);  // at once
  CHECK(bench.taken[3].operation_time == 1200 * kMillisecond + kMillisecond / 2);          // on the grid again
}

TEST_CASE("A PLC that always takes longer is read without pauses") {
  LoopBench bench;
  bench.plc.request_time = 40 * kMillisecond;
  bench.run(50 * kMillisecond, 800 * kMillisecond);
  CHECK(bench.taken.size() == 10);
  CHECK(bench.meter.late.value() == 10);
}

TEST_CASE("The first image over a new connection says so") {
  LoopBench bench;
  bench.plc.before_image = [](PolledPlc& plc) { plc.fails = plc.images == 3; };
  bench.run(50 * kMillisecond, 1'000 * kMillisecond);
  REQUIRE(bench.taken.size() > 4);
  CHECK(bench.losses == 1);
  CHECK(bench.plc.opened == 2);
  CHECK(bench.taken[0].reconnected);
  CHECK_FALSE(bench.taken[1].reconnected);
  CHECK(bench.taken[2].reconnected);
  CHECK_FALSE(bench.taken[3].reconnected);
}

TEST_CASE("A lasting failure is reported once, and pauses grow to 5 s at most") {
  LoopBench bench;
  bench.plc.refuses_connections = true;
  bench.run(50 * kMillisecond, 60'000 * kMillisecond);
  CHECK(bench.messages == std::vector<std::string>{"no connection"});
  const auto& sleeps = bench.clock.sleeps;
  REQUIRE(sleeps.size() > 6);
  for (std::size_t i = 1; i < sleeps.size(); ++i) CHECK(sleeps[i] - sleeps[i - 1] <= 5'000 * kMillisecond);
  CHECK(sleeps.back() - sleeps[sleeps.size() - 2] == 5'000 * kMillisecond);
}

TEST_CASE("An image of which the PLC refuses a part is not used") {
  LoopBench bench;
  bench.plc.before_image = [](PolledPlc& plc) {
    plc.operation = plc.images >= 3;
    plc.refuses_events = plc.images == 3;
  };
  bench.run(50 * kMillisecond, 240 * kMillisecond);
  REQUIRE(bench.taken.size() == 4);
  CHECK(bench.meter.incomplete.value() == 1);
  CHECK_FALSE(bench.taken[1].operation);
  CHECK(bench.taken[2].operation);
  CHECK(bench.taken[2].operation_time == 1151 * kMillisecond);
}

TEST_CASE("What the PLC refuses for 5 s is reported and left out, until it accepts it again") {
  LoopBench bench;
  bench.plc.before_image = [](PolledPlc& plc) { plc.refuses_events = plc.images > 2 && plc.images < 200; };
  bench.run(50 * kMillisecond, 12'000 * kMillisecond);
  CHECK(bench.says("the PLC refuses to read events"));
  CHECK(bench.says("warning: not readable, left out: `I`"));
  CHECK(bench.meter.incomplete.value() == 100);
  REQUIRE(bench.taken.size() > 120);
  CHECK(bench.taken[1].event_is_read);
  CHECK_FALSE(bench.taken[2].event_is_read);
  CHECK(bench.taken.back().event_is_read);
}

TEST_CASE("What the PLC refuses from the start is left out at once") {
  LoopBench bench;
  bench.plc.refuses_events = true;
  bench.run(50 * kMillisecond, 100 * kMillisecond);
  REQUIRE(bench.taken.size() == 2);
  CHECK_FALSE(bench.taken[0].event_is_read);
  CHECK(bench.says("warning: not readable, left out: `I`"));
}

TEST_CASE("A loop never writes") {
  LoopBench bench;
  bench.plc.before_image = [](PolledPlc& plc) { plc.fails = plc.images % 5 == 0; };
  bench.run(50 * kMillisecond, 20'000 * kMillisecond);
  CHECK(bench.plc.writes == 0);
}
