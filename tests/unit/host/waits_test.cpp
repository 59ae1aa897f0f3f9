// What a run reports while its plant waits.
#include "symplant/host/waits.hpp"

#include <memory>

#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

using exec::LinkState;
using tables::kMillisecond;
using tables::kSecond;

struct Bench {
  explicit Bench(host::WaitedLink link, std::string clock = "") : waits({std::move(link)}, std::move(clock)) {}

  std::string at(tables::Time now) {
    std::string text;
    for (const std::string& line : waits.look(now, *meter)) text += line;
    return text;
  }
  std::string at(tables::Time now, LinkState state, bool frozen) {
    meter->note(0, state);
    meter->note_standstill(frozen);
    return at(now);
  }

  std::unique_ptr<exec::CycleMeter> meter = std::make_unique<exec::CycleMeter>();
  host::Waits waits;
};

TEST_CASE("A link without a PLC is reported once, from 5 s on") {
  Bench bench({.name = "link A", .absence = "check it"});
  CHECK(bench.at(5 * kSecond - 1).empty());
  CHECK(bench.at(5 * kSecond) == "warning: no PLC for 5 s: link A, check it\n");
  CHECK(bench.at(6 * kSecond).empty());
}

TEST_CASE("A link with a PLC, and one whose absence is ignored, is not reported") {
  Bench live({.name = "link A", .absence = "check it"});
  CHECK(live.at(5 * kSecond, LinkState::live, false).empty());
  Bench ignored({.name = "link A"});
  CHECK(ignored.at(5 * kSecond).empty());
}

TEST_CASE("Each freeze of the plant and its end are reported, with the link") {
  Bench bench({.name = "link A", .freezes = true});
  CHECK(bench.at(0, LinkState::waiting, true) ==
        "warning: the plant is frozen, since link A is waiting, and its `plant-on-loss` is `freeze`\n");
  CHECK(bench.at(2 * kSecond, LinkState::live, false) == "note: the plant goes on, after 2.0 s\n");
  for (const tables::Time now : {3 * kSecond, 5 * kSecond}) {
    CHECK(bench.at(now, LinkState::lost, true) ==
          "warning: the plant is frozen, since link A is lost, and its `plant-on-loss` is `freeze`\n");
    CHECK(bench.at(now + kSecond, LinkState::lost, true).empty());
    CHECK(bench.at(now + 1500 * kMillisecond, LinkState::live, false) == "note: the plant goes on, after 1.5 s\n");
  }
}

TEST_CASE("A plant that the panel freezes is not that of a link") {
  Bench bench({.name = "link A", .freezes = true});
  CHECK(bench.at(0, LinkState::live, true).empty());
  Bench runs_on({.name = "link A"});
  CHECK(runs_on.at(0, LinkState::lost, true).empty());
}

TEST_CASE("A clock that does not count for 3 s is reported, once for each pause") {
  Bench bench({.name = "link A", .is_clock = true}, "PLC_MS");
  const auto at = [&](tables::Time now, std::uint64_t values) {
    bench.meter->note(exec::PlcClockReading{.values = values});
    return bench.at(now, LinkState::live, false);
  };
  CHECK(at(0, 0).empty());
  CHECK(contains(at(3 * kSecond, 0), "warning: the PLC's clock `PLC_MS` has not counted for 3 s"));
  CHECK(at(4 * kSecond, 0).empty());
  CHECK(at(5 * kSecond, 1).empty());
  CHECK(at(7 * kSecond, 1).empty());
  CHECK(contains(at(8 * kSecond, 1), "has not counted for 3 s"));
}

TEST_CASE("A clock whose link is not live is not reported: its link is") {
  Bench bench({.name = "link A", .is_clock = true}, "PLC_MS");
  bench.meter->note(exec::PlcClockReading{});
  CHECK(bench.at(0, LinkState::lost, false).empty());
  CHECK(bench.at(9 * kSecond, LinkState::lost, false).empty());
}

}  // namespace
}  // namespace symplant::test
