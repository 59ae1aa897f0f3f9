// Nanoseconds a motion in closed loop: the engine on the loads grid and distinct, beside the hand-written limit.
#include <benchmark/benchmark.h>

#include <chrono>

#include "bench/loops.hpp"

namespace symplant::bench {
namespace {

template <class Loop>
void closed_loop(benchmark::State& state) {
  Loop loop(static_cast<std::uint32_t>(state.range(0)));
  std::int64_t motions = 0;
  const auto start = std::chrono::steady_clock::now();
  for (auto _ : state) motions += loop.step();
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
  state.counters["ns_a_motion"] = spent.count() / static_cast<double>(motions);
}

void idle(benchmark::State& state) {
  TwoStatePlant made(static_cast<std::uint32_t>(state.range(0)), {core::kSecond});
  made.plant->advance_to(0);
  core::Time now = 0;
  for (auto _ : state) made.plant->advance_to(++now);
}

BENCHMARK_TEMPLATE(closed_loop, LimitGrid)->Name("limit, grid")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, EngineGrid)->Name("engine, grid")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, EngineDistinct)->Name("engine, distinct")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK(idle)->Name("engine, idle advance_to")->Arg(1'000)->Arg(100'000);

}  // namespace
}  // namespace symplant::bench
