// The cycle: its order, its deadlines, and its reaction to late real time. All on a clock that the tests control.
#include "symplant/exec/cycle.hpp"

#include <atomic>
#include <functional>
#include <vector>

#include "support/catch.hpp"
#include "unit/exec/cycle_bench.hpp"

using namespace symplant;
using test::Bench;
using test::every_10_ms;
using test::FakeLink;
using test::kMillisecond;
using test::kSecond;
using test::Time;

TEST_CASE("A link receives the events of the first instant before the first cycle") {
  Bench bench;
  bool at_p1 = false;
  bool idle = false;
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (bench.link.entries.size() > 1) return;
    at_p1 = plant.event(test::cell::kAgvAtP1);
    idle = plant.event(test::cell::kMachineIdle1);
  };
  bench.run({.until = 0});
  REQUIRE(bench.link.entries.size() == 1);
  CHECK(bench.link.entries[0].call == FakeLink::Call::write);
  CHECK(bench.link.entries[0].plant_time == 0);
  CHECK(at_p1);
  CHECK(idle);
}

TEST_CASE("Each cycle reads operations, advances the plant, writes events") {
  Bench bench;
  const auto statistics = bench.run({.until = 30 * kMillisecond});
  using Call = FakeLink::Call;
  const std::vector<std::pair<Call, Time>> expected = {
      {Call::write, 0},
      {Call::read, 0},
      {Call::write, 10 * kMillisecond},
      {Call::read, 10 * kMillisecond},
      {Call::write, 20 * kMillisecond},
      {Call::read, 20 * kMillisecond},
      {Call::write, 30 * kMillisecond},
  };
  std::vector<std::pair<Call, Time>> seen;
  for (const auto& entry : bench.link.entries) seen.emplace_back(entry.call, entry.plant_time);
  CHECK(seen == expected);
  CHECK(statistics.cycles == 3);
}

TEST_CASE("An operation read in a cycle belongs to that cycle's instant") {
  Bench bench;
  std::vector<Time> left;
  std::vector<Time> arrived;
  bench.link.on_read = [](plant::Plant& plant) { plant.set_operation(test::cell::kAgvToP2, true); };
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (left.empty() && !plant.event(test::cell::kAgvAtP1)) left.push_back(plant.now());
    if (arrived.empty() && plant.event(test::cell::kAgvAtP2)) arrived.push_back(plant.now());
  };
  bench.run({.until = 2 * kSecond});
  CHECK(left == std::vector<Time>{10 * kMillisecond});
  CHECK(arrived == std::vector<Time>{1010 * kMillisecond});
}

TEST_CASE("Changed events are those since the link's last turn") {
  Bench bench;
  bench.run({.until = 50 * kMillisecond});
  std::size_t changed = 0;
  for (std::size_t i = 1; i < bench.link.entries.size(); ++i) changed += bench.link.entries[i].changed_words;
  CHECK(bench.link.entries[0].changed_words == 1);
  CHECK(changed == 0);
}

TEST_CASE("Every link has its turn in every cycle") {
  Bench bench;
  FakeLink other;
  const std::array<exec::Exchange*, 2> links = {&bench.link, &other};
  exec::run_cycles(*bench.plant, links, {.until = 50 * kMillisecond},
                   {.clock = bench.clock, .meter = bench.meter, .stop = bench.stop});
  CHECK(other.written() == every_10_ms(0, 5));
  CHECK(bench.link.written() == every_10_ms(0, 5));
}

TEST_CASE("A run on time counts its cycles and nothing else") {
  Bench bench;
  const Time begin = bench.clock.now();
  const auto statistics = bench.run({.until = kSecond});
  CHECK(statistics.cycles == 100);
  CHECK(statistics.overruns == 0);
  CHECK(statistics.slipped == 0);
  CHECK(statistics.lateness.max == 0);
  CHECK(bench.clock.now() - begin == kSecond);
}

TEST_CASE("Work that takes part of the cycle shifts no deadline") {
  Bench bench;
  const Time begin = bench.clock.now();
  bench.link.on_write = [&](const plant::Plant&) { bench.clock.pass(9 * kMillisecond); };
  const auto statistics = bench.run({.until = 100 * kMillisecond});
  CHECK(statistics.overruns == 0);
  CHECK(statistics.lateness.max == 0);
  CHECK(bench.clock.now() - begin == 118 * kMillisecond);  // 9 before the first, 10 cycles, 9 at the end
}

TEST_CASE("A late plant catches up in order, each cycle at its own time") {
  Bench bench;
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (plant.now() == 30 * kMillisecond) bench.clock.pass(35 * kMillisecond);
  };
  const auto statistics = bench.run({.until = 100 * kMillisecond});
  CHECK(bench.link.written() == every_10_ms(0, 10));
  CHECK(statistics.overruns == 3);  // the long cycle, and the two that ended after the next was due
  CHECK(statistics.lateness.max == 25 * kMillisecond);
  CHECK(statistics.slipped == 0);
}

TEST_CASE("Exactly ten cycles are caught up without a slip") {
  Bench bench;
  const Time begin = bench.clock.now();
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (plant.now() == 30 * kMillisecond) bench.clock.pass(119 * kMillisecond);
  };
  const auto statistics = bench.run({.until = 200 * kMillisecond});
  CHECK(statistics.slipped == 0);
  CHECK(statistics.lateness.max == 109 * kMillisecond);
  CHECK(bench.clock.now() - begin == 200 * kMillisecond);
}

TEST_CASE("After more than ten cycles plant time slips, and the lost time is counted") {
  Bench bench;
  const Time begin = bench.clock.now();
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (plant.now() == 30 * kMillisecond) bench.clock.pass(500 * kMillisecond);
  };
  const auto statistics = bench.run({.until = kSecond});
  CHECK(bench.link.written() == every_10_ms(0, 100));
  CHECK(statistics.slipped == 390 * kMillisecond);
  CHECK(statistics.lateness.max == 490 * kMillisecond);
  CHECK(statistics.overruns == 11);
  CHECK(bench.clock.now() - begin == 1390 * kMillisecond);
}

TEST_CASE("Without catching up every whole cycle of delay is slipped") {
  Bench bench;
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (plant.now() == 30 * kMillisecond) bench.clock.pass(35 * kMillisecond);
  };
  const auto statistics = bench.run({.until = 100 * kMillisecond, .max_catch_up = 0});
  CHECK(bench.link.written() == every_10_ms(0, 10));
  CHECK(statistics.slipped == 20 * kMillisecond);
}

TEST_CASE("A plant that is always too slow continues, and loses time steadily") {
  Bench bench;
  bench.link.on_write = [&](const plant::Plant&) { bench.clock.pass(20 * kMillisecond); };
  const auto statistics = bench.run({.until = kSecond});
  CHECK(statistics.cycles == 100);
  CHECK(statistics.overruns == 100);
  CHECK(statistics.slipped > 800 * kMillisecond);
  CHECK(statistics.slipped < kSecond);
}

TEST_CASE("A link that freezes the plant keeps its turns while plant time stops, and none is caught up") {
  Bench bench;
  int reads = 0;
  bench.link.on_read = [&](plant::Plant&) {
    ++reads;
    bench.link.freezes = reads >= 3 && reads < 8;
    bench.link.stands = bench.link.freezes ? exec::LinkState::lost : exec::LinkState::live;
  };
  const Time begin = bench.clock.now();
  const auto statistics = bench.run({.until = 40 * kMillisecond});
  const Time ms = kMillisecond;
  CHECK(bench.link.written() ==
        std::vector<Time>{0, 10 * ms, 20 * ms, 20 * ms, 20 * ms, 20 * ms, 20 * ms, 20 * ms, 30 * ms, 40 * ms});
  CHECK(statistics.frozen == 50 * ms);
  CHECK(statistics.cycles == 9);
  CHECK(statistics.overruns == 0);
  CHECK(statistics.slipped == 0);
  CHECK(bench.clock.now() == begin + 90 * ms);
  CHECK(bench.link.reported[2].live == 1);
  CHECK_FALSE(bench.link.reported[2].frozen);
  CHECK(bench.link.reported[3].live == 0);
  CHECK(bench.link.reported[3].frozen);
}

TEST_CASE(
    "A plant whose link freezes it from the start shows its first events, and does not move until the link is live") {
  Bench bench;
  std::vector<bool> at_p1;
  int reads = 0;
  bench.link.freezes = true;
  bench.link.on_read = [&](plant::Plant& plant) {
    bench.link.freezes = ++reads < 5;
    plant.set_operation(test::cell::kAgvToP2, true);
  };
  bench.link.on_write = [&](const plant::Plant& plant) { at_p1.push_back(plant.event(test::cell::kAgvAtP1)); };
  bench.run({.until = 20 * kMillisecond});
  const std::vector<bool> expected = {true, true, true, true, true, false, false};
  CHECK(at_p1 == expected);
  CHECK(bench.link.entries[8].plant_time == 0);
}

TEST_CASE("The requested end ends a plant that a link freezes, after as long as it would have run, and after 5 s") {
  const Time until = GENERATE(1, 60) * kSecond;
  Bench bench;
  int reads = 0;
  bench.link.on_read = [&](plant::Plant&) { bench.link.freezes = ++reads > 2; };
  const Time begin = bench.clock.now();
  bench.run({.until = until});
  CHECK(bench.plant->now() == 20 * kMillisecond);
  const Time waited = std::max(until - 20 * kMillisecond, exec::kPatience);
  CHECK(bench.clock.now() - begin == 20 * kMillisecond + waited);
}

TEST_CASE("Each wait counts for itself: a link that is back in time does not shorten the run") {
  Bench bench;
  int reads = 0;
  bench.link.on_read = [&](plant::Plant&) { bench.link.freezes = ++reads % 450 != 0; };  // 4.5 s each
  bench.run({.until = 50 * kMillisecond});
  CHECK(bench.plant->now() == 50 * kMillisecond);
}

TEST_CASE("A frozen run without a requested end goes on") {
  Bench bench;
  int reads = 0;
  bench.link.on_read = [&](plant::Plant&) {
    bench.link.freezes = true;
    bench.stop = ++reads == 100'000;
  };
  CHECK(bench.run({}).cycles == 100'000);
}

TEST_CASE("A link receives the number of cycles, the time, and the end of the run") {
  Bench bench;
  bench.run({.until = 30 * kMillisecond});
  std::vector<std::uint64_t> cycles;
  for (const exec::CycleStatus& status : bench.link.reported) cycles.push_back(status.cycles);
  CHECK(cycles == std::vector<std::uint64_t>{0, 0, 1, 2});
  CHECK(bench.link.read_at.size() == 3);
  CHECK(bench.link.read_at.back() - bench.link.read_at.front() == 20 * kMillisecond);
  CHECK(bench.link.left == 1);
}

TEST_CASE("The last cycle ends at the requested end, even within a cycle") {
  Bench bench;
  bench.run({.until = 25 * kMillisecond});
  CHECK(bench.link.written() == std::vector<Time>{0, 10 * kMillisecond, 20 * kMillisecond, 25 * kMillisecond});
}

TEST_CASE("A stop ends the run after the current cycle") {
  Bench bench;
  bench.link.on_write = [&](const plant::Plant& plant) { bench.stop = plant.now() == 50 * kMillisecond; };
  const auto statistics = bench.run({});
  CHECK(statistics.cycles == 5);
  CHECK(bench.link.written() == every_10_ms(0, 5));
}

TEST_CASE("A stop is seen in the middle of a long cycle") {
  Bench bench;
  bench.clock.on_sleep = [&] { bench.stop = true; };
  const auto statistics = bench.run({.cycle = 3600 * kSecond});
  CHECK(statistics.cycles == 0);
  CHECK(bench.clock.longest_sleep <= 100 * kMillisecond);
}

TEST_CASE("A sleep that ends early starts no cycle early") {
  Bench bench;
  bench.clock.wakes_early = true;
  const Time begin = bench.clock.now();
  bench.link.on_write = [&](const plant::Plant& plant) { CHECK(bench.clock.now() - begin == plant.now()); };
  const auto statistics = bench.run({.until = 100 * kMillisecond});
  CHECK(statistics.cycles == 10);
}

TEST_CASE("A plant that has run already continues from its own time") {
  Bench bench;
  bench.plant->advance_to(5 * kSecond);
  bench.run({.until = 5 * kSecond + 20 * kMillisecond});
  CHECK(bench.link.written() ==
        std::vector<Time>{5 * kSecond, 5 * kSecond + 10 * kMillisecond, 5 * kSecond + 20 * kMillisecond});
}

TEST_CASE("The monotonic clock sleeps until the requested time") {
  exec::MonotonicClock clock;
  const Time begin = clock.now();
  while (clock.now() < begin + kMillisecond) clock.sleep_until(begin + kMillisecond);
  CHECK(clock.now() >= begin + kMillisecond);
  clock.sleep_until(begin);  // in the past: returns at once
}
