// How late the cycle is: exact overruns, quantiles, busy waiting at the end of a sleep.
#include <cstdlib>

#include "support/catch.hpp"
#include "unit/exec/cycle_bench.hpp"

namespace symplant::test {
namespace {

/// A cycle at plant time `at` takes `work`, all others take no time.
void work_once(Bench& bench, Time at, Time work) {
  bench.link.on_write = [&bench, at, work](const plant::Plant& plant) {
    if (plant.now() == at) bench.clock.pass(work);
  };
}

TEST_CASE("A cycle that takes exactly the cycle time is one overrun, a nanosecond less is no overrun") {
  Bench exact;
  work_once(exact, 30 * kMillisecond, 10 * kMillisecond);
  CHECK(exact.run({.until = 100 * kMillisecond}).overruns == 1);
  Bench shorter;
  work_once(shorter, 30 * kMillisecond, 10 * kMillisecond - 1);
  CHECK(shorter.run({.until = 100 * kMillisecond}).overruns == 0);
}

TEST_CASE("A cycle of three cycle times is three overruns: its own and those of the two that end late") {
  Bench bench;
  work_once(bench, 30 * kMillisecond, 30 * kMillisecond);
  const auto statistics = bench.run({.until = 100 * kMillisecond});
  CHECK(statistics.overruns == 3);
  CHECK(statistics.slipped == 0);
  CHECK(statistics.work.max == 30 * kMillisecond);
  CHECK(statistics.lateness.max == 20 * kMillisecond);
}

TEST_CASE("Cycles of three cycle times each overrun, run late by at most the catch-up, and lose the rest") {
  Bench bench;
  const Time begin = bench.clock.now();
  bench.link.on_write = [&](const plant::Plant&) { bench.clock.pass(30 * kMillisecond); };
  const auto statistics = bench.run({.until = kSecond, .max_catch_up = 2});
  CHECK(statistics.cycles == 100);
  CHECK(statistics.overruns == 100);
  const Time before = 30 * kMillisecond;  // the first write_events(), before the first deadline is set
  CHECK(bench.clock.now() - begin == before + 10 * kMillisecond + 100 * 30 * kMillisecond);
  // The delay of plant time: all that slipped, and what is still to be caught up.
  const Time behind = bench.clock.now() - begin - before - kSecond;
  CHECK(statistics.slipped <= behind);
  CHECK(behind - statistics.slipped < 3 * 10 * kMillisecond + 30 * kMillisecond);
}

TEST_CASE("A process stopped for 5 s counts two cycles of PLC silence, not 5 s") {
  Bench bench;
  bool stood = false;
  bench.clock.on_sleep = [&] {
    if (stood || bench.plant->now() != 50 * kMillisecond) return;
    stood = true;
    bench.clock.pass(5 * kSecond);
  };
  bench.run({.until = kSecond});
  Time longest = 0;
  const std::vector<Time>& read_at = bench.link.read_at;
  for (std::size_t i = 1; i < read_at.size(); ++i) longest = std::max(longest, read_at[i] - read_at[i - 1]);
  CHECK(longest == 20 * kMillisecond);
  REQUIRE(stood);
}

TEST_CASE("A process that is always too slow counts the true silence of its PLCs, up to two cycles each") {
  Bench bench;
  bench.link.on_write = [&](const plant::Plant&) { bench.clock.pass(15 * kMillisecond); };
  bench.run({.until = kSecond, .max_catch_up = 0});
  const std::vector<Time>& read_at = bench.link.read_at;
  CHECK(read_at[50] - read_at[40] == 150 * kMillisecond);
}

TEST_CASE("A process stopped for 5 s runs at most the catch-up at once, and counts what it lost") {
  Bench bench;
  std::vector<Time> starts;
  bool stood = false;
  bench.clock.on_sleep = [&] {
    if (stood || bench.plant->now() != 50 * kMillisecond) return;
    stood = true;
    bench.clock.pass(5 * kSecond);
  };
  bench.link.on_read = [&](plant::Plant&) { starts.push_back(bench.clock.now()); };
  const auto statistics = bench.run({.until = kSecond});
  std::size_t at_once = 0;
  for (std::size_t i = 1; i < starts.size(); ++i) at_once += starts[i] == starts[i - 1] ? 1U : 0U;
  CHECK(at_once == 10);
  CHECK(statistics.slipped == 4900 * kMillisecond);
  CHECK(statistics.overruns == 10);  // of eleven due at once the last is on time
  CHECK(statistics.cycles == 100);
}

TEST_CASE("The last microseconds of a wait are busy: one sleep up to them, then reads of the clock") {
  Bench bench;
  std::vector<Time> wakes;
  bench.clock.costs = 100;
  bench.clock.on_sleep = [&] { wakes.push_back(bench.clock.now() - 100); };
  const auto statistics = bench.run({.until = 50 * kMillisecond, .spin = 50 * tables::kMicrosecond});
  CHECK(wakes.size() == 5);
  for (std::size_t i = 1; i < wakes.size(); ++i) CHECK(wakes[i] - wakes[i - 1] == 10 * kMillisecond);
  CHECK(statistics.lateness.max < 100);
}

TEST_CASE("A stop is seen during busy waiting") {
  Bench bench;
  bench.clock.costs = 100;
  int looks = 0;
  bench.clock.on_look = [&] { bench.stop = ++looks == 1000; };
  CHECK(bench.run({.cycle = 3600 * kSecond, .spin = 3600 * kSecond - 1}).cycles == 0);
  CHECK(looks == 1000);
}

TEST_CASE("A stop is seen in the middle of a catch-up of any length") {
  Bench bench;
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (plant.now() == 10 * kMillisecond) bench.clock.pass(3600 * kSecond);
    bench.stop = plant.now() == 50 * kMillisecond;
  };
  const auto statistics = bench.run({.max_catch_up = 1'000'000});
  CHECK(statistics.cycles == 5);
  CHECK(statistics.slipped == 0);
}

TEST_CASE("Jitter is the difference between the distance of two starts and the cycle time") {
  Bench bench;
  work_once(bench, 30 * kMillisecond, 14 * kMillisecond);
  const auto statistics = bench.run({.until = 100 * kMillisecond});
  CHECK(statistics.jitter.count == 9);
  CHECK(statistics.jitter.p50 == 0);
  CHECK(statistics.jitter.max == 4 * kMillisecond);  // one 4 ms late, the next on time again
  CHECK(statistics.jitter.p999 == 4 * kMillisecond);
}

TEST_CASE("A shorter last cycle is no jitter") {
  Bench bench;
  const auto statistics = bench.run({.until = 41 * kMillisecond});
  CHECK(statistics.jitter.count == 4);
  CHECK(statistics.jitter.max == 0);
}

TEST_CASE("The meter of a run can be read during the run") {
  Bench bench;
  bench.link.stands = exec::LinkState::lost;
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (plant.now() != 50 * kMillisecond) return;
    CHECK(bench.meter.statistics().cycles == 4);
    CHECK(bench.meter.state(0) == exec::LinkState::lost);
    CHECK(bench.meter.beats.value() >= 5);
  };
  bench.run({.until = 100 * kMillisecond});
}

}  // namespace
}  // namespace symplant::test
