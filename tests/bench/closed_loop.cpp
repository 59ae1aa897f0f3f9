// Nanoseconds a motion in closed loop: the engine on the loads grid and distinct, beside the hand-written limit.
//
// A motion is: command, leave, travel, arrive, the controller's answer. The controller is the same for all: for every
// event that came on it takes back the command that led there and gives the other one.
#include <benchmark/benchmark.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "bench/limit.hpp"
#include "bench/two_state_plant.hpp"

namespace symplant::bench {
namespace {

using core::kMillisecond;
using core::Time;

constexpr std::uint32_t kTicks = 100;  // of 10 ms: every travel takes a second, arrivals spread over all of them
constexpr Time kTick = 10 * kMillisecond;

/// Answers an arrival: `write(bit, on)` sets an operation.
template <class Write>
void answer(std::uint32_t word, std::uint64_t arrived, Write write, std::int64_t& motions) {
  for (; arrived != 0; arrived &= arrived - 1) {
    const auto bit = word * 64 + static_cast<std::uint32_t>(std::countr_zero(arrived));
    write(bit, false);
    write(bit ^ 1, true);
    ++motions;
  }
}

void limit_grid(benchmark::State& state) {
  const auto devices = static_cast<std::uint32_t>(state.range(0));
  LimitPlant plant(devices, kTicks);
  std::int64_t motions = 0;
  const auto write = [&](std::uint32_t bit, bool on) {
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    std::uint64_t& word = plant.operations[bit / 64];
    word = on ? word | mask : word & ~mask;
  };
  const auto scan = [&] {
    plant.tick();
    for (std::uint32_t word = 0; word < plant.changed.size(); ++word) {
      const std::uint64_t arrived = plant.changed[word];
      plant.changed[word] = 0;
      answer(word, arrived, write, motions);
    }
  };
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {  // a hundredth of the devices starts in each tick
    for (std::uint32_t d = tick; d < devices; d += kTicks) write(2 * d + 1, true);
    scan();
  }
  motions = 0;
  for (auto _ : state) scan();
  state.counters["ns_per_motion"] = benchmark::Counter(static_cast<double>(motions) * 1e-9,
                                                       benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["motions"] = static_cast<double>(motions);
}

/// The controller's look at what the plant changed.
template <class Write>
void answer_plant(core::Plant& plant, Write write, std::vector<std::uint64_t>& seen, std::int64_t& motions) {
  for (const std::uint32_t word : plant.changed_events()) {
    const std::uint64_t now = plant.events()[word];
    const std::uint64_t arrived = now & ~seen[word];
    seen[word] = now;
    answer(word, arrived, write, motions);
  }
  plant.forget_changed_events();
}

void engine_grid(benchmark::State& state) {
  const auto devices = static_cast<std::uint32_t>(state.range(0));
  TwoStatePlant made(devices, {kTicks * kTick});
  core::Plant& plant = *made.plant;
  std::vector<std::uint64_t> seen(made.tables.event_bits / 64);
  std::int64_t motions = 0;
  Time now = 0;
  const auto write = [&](std::uint32_t bit, bool on) { plant.set_operation(bit, on); };
  const auto scan = [&] {
    plant.advance_to(now);
    answer_plant(plant, write, seen, motions);
    now += kTick;
  };
  plant.advance_to(0);
  for (std::uint32_t word = 0; word < seen.size(); ++word) seen[word] = plant.events()[word];
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    for (std::uint32_t d = tick; d < devices; d += kTicks) write(2 * d + 1, true);
    scan();
  }
  motions = 0;
  for (auto _ : state) scan();
  state.counters["ns_per_motion"] = benchmark::Counter(static_cast<double>(motions) * 1e-9,
                                                       benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["motions"] = static_cast<double>(motions);
}

void engine_distinct(benchmark::State& state) {
  const auto devices = static_cast<std::uint32_t>(state.range(0));
  // Starts 10 us apart in a second or longer, travels that differ by a prime number of ns: no two arrivals coincide.
  std::vector<Time> travels;
  for (std::uint32_t d = 0; d < devices; ++d) travels.push_back(core::kSecond + 7919 * Time{d});
  TwoStatePlant made(devices, travels);
  core::Plant& plant = *made.plant;
  std::vector<std::uint64_t> seen(made.tables.event_bits / 64);
  std::int64_t motions = 0;
  const auto write = [&](std::uint32_t bit, bool on) { plant.set_operation(bit, on); };
  plant.advance_to(0);
  for (std::uint32_t word = 0; word < seen.size(); ++word) seen[word] = plant.events()[word];
  Time now = 1;
  for (std::uint32_t d = 0; d < devices; ++d) {
    write(2 * d + 1, true);
    plant.advance_to(now += 10'007);
    answer_plant(plant, write, seen, motions);
  }
  const auto arrival = [&] {
    plant.advance_to(plant.next_due());
    answer_plant(plant, write, seen, motions);
    plant.advance_to(plant.now() + 1);  // the answer is an instant of its own
    answer_plant(plant, write, seen, motions);
  };
  for (std::uint32_t d = 0; d < 2 * devices; ++d) arrival();
  motions = 0;
  for (auto _ : state) arrival();
  state.counters["ns_per_motion"] = benchmark::Counter(static_cast<double>(motions) * 1e-9,
                                                       benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["motions"] = static_cast<double>(motions);
}

void engine_idle(benchmark::State& state) {
  TwoStatePlant made(static_cast<std::uint32_t>(state.range(0)), {core::kSecond});
  made.plant->advance_to(0);
  Time now = 0;
  for (auto _ : state) made.plant->advance_to(++now);
}

BENCHMARK(limit_grid)->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK(engine_grid)->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK(engine_distinct)->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK(engine_idle)->Arg(1'000)->Arg(100'000);

}  // namespace
}  // namespace symplant::bench
