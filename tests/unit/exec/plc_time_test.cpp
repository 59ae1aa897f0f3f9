// The cycle with plant time from a PLC's clock, on a clock and a link that the tests control.
#include "symplant/exec/plc_time.hpp"

#include "support/catch.hpp"
#include "unit/exec/cycle_bench.hpp"

namespace symplant::test {
namespace {

tables::PlantTables tables_with_counter() {
  tables::PlantTables tables = cell_tables();
  tables.operation_slots = 1;
  return tables;
}

class CountedPlcTime final : public exec::PlcTime {
 public:
  using PlcTime::PlcTime;
  std::vector<Time> restarted_at;

 protected:
  void restarted(const plant::Plant& plant) noexcept override { restarted_at.push_back(plant.now()); }
};

/// A PLC writes its counter, in ms, in each tenth read of a cycle of 10 ms.
struct PlcBench {
  PlcBench() {
    link.on_read = [this](plant::Plant& read) {
      if (before) before();
      if (++reads % 10 == 0) read.set_operation_value(0, counter());
    };
  }
  std::uint64_t counter() {
    return static_cast<std::uint64_t>(rate * static_cast<double>(clock.now() / kMillisecond)) & 0xFFFF;
  }
  exec::CycleStatistics run(exec::CycleOptions options, std::span<exec::Exchange* const> links) {
    exec::run_cycles(*plant, links, options, {.clock = clock, .meter = meter, .stop = stop, .plc_time = &plc_time});
    return meter.statistics();
  }
  exec::CycleStatistics run(exec::CycleOptions options) {
    const std::array<exec::Exchange*, 1> links = {&link};
    return run(options, links);
  }
  /// Ends the run after this many reads.
  void stop_after(int count) {
    before = [this, count] { stop = reads + 1 >= count; };
  }

  tables::PlantTables tables = tables_with_counter();
  OwnedPlant plant{tables};
  FakeClock clock;
  FakeLink link;
  exec::CycleMeter meter;
  std::atomic<bool> stop{false};
  CountedPlcTime plc_time{{16}, *plant, 0, link};
  int reads = 0;
  double rate = 1;
  std::function<void()> before;
};

bool never_goes_back(const std::vector<Time>& times) { return std::is_sorted(times.begin(), times.end()); }

TEST_CASE("With a PLC's clock the wall clock paces the cycles, and the PLC plant time") {
  for (const double rate : {0.2, 0.8, 1.0, 1.2, 5.0}) {
    INFO(rate);
    PlcBench bench;
    bench.rate = rate;
    const Time begin = bench.clock.now();
    const auto statistics = bench.run({.until = 100 * kSecond});
    CHECK(bench.plant->now() == 100 * kSecond);
    CHECK(never_goes_back(bench.link.written()));
    const double real = static_cast<double>(bench.clock.now() - begin) / 1e9;
    CHECK(real * rate > 99.9);
    CHECK(real * rate < 100.0 + 3 * 0.1 * rate);
    CHECK(static_cast<double>(statistics.cycles) == Approx(real * 100));
    CHECK(statistics.lateness.max == 0);
    CHECK(statistics.jitter.max == 0);
    CHECK(statistics.plc_clock->values == static_cast<std::uint64_t>(bench.reads / 10));
    CHECK(static_cast<double>(statistics.plc_clock->largest_phase_error) <= (100.0 * rate + 1) * 1e6);
    CHECK(statistics.plc_clock->restarts == 0);
  }
}

TEST_CASE("Plant time waits for the first two values of the PLC") {
  PlcBench bench;
  bench.stop_after(20);
  bench.run({});
  CHECK(bench.link.written()[19] == 0);
  CHECK(bench.link.written()[20] == 20 * kMillisecond);
}

TEST_CASE("A plant that waits still answers the PLC: an operation of this moment moves it") {
  PlcBench bench;
  bench.stop_after(5);
  bench.link.on_read = [&](plant::Plant& plant) {
    bench.before();
    if (++bench.reads == 3) plant.set_operation(cell::kAgvToP2, true);
  };
  bench.run({});
  CHECK(bench.plant->now() == 0);
  CHECK_FALSE(bench.plant->event(cell::kAgvAtP1));
}

TEST_CASE("A PLC that stops for a minute stops the plant, at most one interval ahead") {
  PlcBench bench;
  std::uint64_t stopped_at = 0;
  bench.link.on_read = [&](plant::Plant& plant) {
    ++bench.reads;
    const bool stopped = bench.reads > 100 && bench.reads <= 6100;
    if (stopped && stopped_at == 0) stopped_at = bench.counter();
    if (bench.reads == 6100) CHECK(plant.now() <= kSecond + 100 * kMillisecond);
    const std::uint64_t away = bench.reads > 6100 ? 60'000 : 0;
    if (!stopped && bench.reads % 10 == 0) plant.set_operation_value(0, bench.counter() - away);
  };
  const auto statistics = bench.run({.until = 2 * kSecond});
  CHECK(bench.plc_time.restarted_at.empty());
  CHECK(statistics.plc_clock->waits > 5900);
  CHECK(statistics.cycles < 6230);
}

TEST_CASE("A late plant runs one cycle, and plant time stays with the PLC") {
  PlcBench bench;
  Time base = 0;  // when the first value came
  Time ahead = 0;
  bench.link.on_write = [&](const plant::Plant& plant) {
    if (base != 0) ahead = std::max(ahead, plant.now() - (bench.clock.now() - base));
    if (bench.reads == 105) bench.clock.pass(500 * kMillisecond);
  };
  bench.link.on_read = [&](plant::Plant& plant) {
    if (++bench.reads == 10) base = bench.clock.now();
    if (bench.reads % 10 == 0 || bench.reads == 106) plant.set_operation_value(0, bench.counter());
  };
  const Time begin = bench.clock.now();
  const auto statistics = bench.run({.until = 3 * kSecond});
  CHECK(statistics.slipped == 0);
  CHECK(statistics.lateness.max == 490 * kMillisecond);
  CHECK(statistics.plc_clock->largest_phase_error <= 560 * kMillisecond);
  CHECK(ahead <= 50 * kMillisecond);  // the cycles that were skipped count as cycles
  const Time real = bench.clock.now() - begin;
  CHECK(real > 2900 * kMillisecond);
  CHECK(real < 3700 * kMillisecond);
  CHECK(static_cast<Time>(statistics.cycles) == real / (10 * kMillisecond) - 49);
}

TEST_CASE("While its link is lost plant time waits, and the return is a restart") {
  PlcBench bench;
  bench.link.on_read = [&](plant::Plant& plant) {
    ++bench.reads;
    const bool lost = bench.reads > 100 && bench.reads <= 300;
    bench.link.stands = lost ? exec::LinkState::lost : exec::LinkState::live;
    if (bench.reads == 101) plant.set_operation_value(0, 0);  // the link's policy on loss
    if (!lost && bench.reads != 301 && bench.reads % 10 == 0) plant.set_operation_value(0, bench.counter());
  };
  const auto statistics = bench.run({.until = 2 * kSecond});
  REQUIRE(bench.plc_time.restarted_at.size() == 1);
  CHECK(bench.plc_time.restarted_at[0] == bench.link.written()[150]);
  CHECK(statistics.plc_clock->restarts == 1);
  CHECK(never_goes_back(bench.link.written()));
  CHECK(bench.link.written()[320] > bench.link.written()[150]);
}

TEST_CASE("A PLC that is not live yet has no clock, and its first value is no restart") {
  PlcBench bench;
  bench.link.stands = exec::LinkState::waiting;
  bench.before = [&] {
    if (bench.reads == 50) bench.link.stands = exec::LinkState::live;
  };
  bench.run({.until = kSecond});
  CHECK(bench.link.written()[69] == 0);
  CHECK(bench.plc_time.reading().restarts == 0);
}

TEST_CASE("The requested end ends a run whose PLC never counts, or whose link stays lost") {
  const bool lost = GENERATE(false, true);
  PlcBench bench;
  bench.link.on_read = [&](plant::Plant& plant) {
    ++bench.reads;
    if (lost && bench.reads > 100) bench.link.stands = exec::LinkState::lost;
    if (lost && bench.reads <= 100 && bench.reads % 10 == 0) plant.set_operation_value(0, bench.counter());
  };
  const Time begin = bench.clock.now();
  const auto statistics = bench.run({.until = 8 * kSecond});
  CHECK(bench.plant->now() < 8 * kSecond);
  CHECK(statistics.plc_clock->has_counted() == lost);
  CHECK(bench.clock.now() - begin >= 8 * kSecond - 200 * kMillisecond);
  CHECK(bench.clock.now() - begin <= 8 * kSecond + 200 * kMillisecond);
}

TEST_CASE("A plant that another link freezes is not caught up by the PLC's clock") {
  PlcBench bench;
  FakeLink other;
  bench.before = [&] { other.freezes = bench.reads >= 100 && bench.reads < 400; };
  const std::array<exec::Exchange*, 2> links = {&bench.link, &other};
  const Time begin = bench.clock.now();
  const auto statistics = bench.run({.until = 3 * kSecond}, links);
  CHECK(statistics.frozen == 3 * kSecond);
  CHECK(bench.plc_time.restarted_at.empty());
  const Time real = bench.clock.now() - begin;
  CHECK(real > 6 * kSecond);
  CHECK(real < 6500 * kMillisecond);
}

TEST_CASE("A link that freezes the plant and has its clock restarts it when it is back") {
  PlcBench bench;
  bench.before = [&] {
    bench.link.freezes = bench.reads >= 100 && bench.reads < 400;
    bench.link.stands = bench.link.freezes ? exec::LinkState::lost : exec::LinkState::live;
  };
  bench.run({.until = 3 * kSecond});
  CHECK(bench.plc_time.restarted_at.size() == 1);
}

}  // namespace
}  // namespace symplant::test
