// Nanoseconds per motion in closed loop: the engine on all loads, and two plants written by hand for one load.
#include <benchmark/benchmark.h>

#include <cstring>
#include <ctime>
#include <vector>

#include "bench/loops.hpp"
#include "bench/track_plant.hpp"

namespace symplant::bench {
namespace {

template <class Loop>
void closed_loop(benchmark::State& state) {
  Loop loop(static_cast<std::uint32_t>(state.range(0)));
  std::int64_t motions = 0;
  const std::clock_t start = std::clock();  // CPU time, so that other processes on the machine do not count
  for (auto _ : state) motions += loop.step();
  const double spent = static_cast<double>(std::clock() - start) * (1e9 / CLOCKS_PER_SEC);
  state.counters["ns_a_motion"] = spent / static_cast<double>(motions);
}

void idle(benchmark::State& state) {
  TwoStatePlant made(static_cast<std::uint32_t>(state.range(0)), {tables::kSecond});
  made.plant->advance_to(0);
  tables::Time now = 0;
  for (auto _ : state) made.plant->advance_to(++now);
}

/// Saves and restores a plant; `copy_ns` is the time to copy as many bytes there and back.
void save_and_restore(benchmark::State& state) {
  TwoStatePlant made(static_cast<std::uint32_t>(state.range(0)), {tables::kSecond});
  made.plant->advance_to(0);
  std::vector<std::byte> saved(made.plant->save().size());
  for (auto _ : state) {
    std::memcpy(saved.data(), made.plant->save().data(), saved.size());
    benchmark::DoNotOptimize(made.plant->restore(saved));
  }
  state.counters["bytes"] = static_cast<double>(saved.size());
  state.counters["GB_a_s"] =
      benchmark::Counter(2e-9 * static_cast<double>(saved.size()), benchmark::Counter::kIsIterationInvariantRate);
}

/// The baseline for save and restore.
void copy_there_and_back(benchmark::State& state) {
  std::vector<std::byte> here(static_cast<std::size_t>(state.range(0)));
  std::vector<std::byte> there(here.size());
  for (auto _ : state) {
    std::memcpy(there.data(), here.data(), here.size());
    benchmark::ClobberMemory();
    std::memcpy(here.data(), there.data(), here.size());
    benchmark::ClobberMemory();
  }
  state.counters["GB_a_s"] =
      benchmark::Counter(2e-9 * static_cast<double>(here.size()), benchmark::Counter::kIsIterationInvariantRate);
}

/// Memory of a unit: its row, its share of the flat block, and its share of all engine memory.
template <class Made>
void memory(benchmark::State& state) {
  const auto devices = static_cast<std::uint32_t>(state.range(0));
  const Made made(devices, {tables::kSecond});
  for (auto _ : state) benchmark::DoNotOptimize(plant::Plant::memory_size(made.tables));
  const auto share = [&](std::size_t bytes) { return static_cast<double>(bytes) / devices; };
  state.counters["row_and_block"] = share(made.plant->save().size()) + sizeof(tables::UnitRow);
  state.counters["with_index"] = share(plant::Plant::memory_size(made.tables)) + sizeof(tables::UnitRow);
}

BENCHMARK_TEMPLATE(closed_loop, LimitGrid)->Name("limit, grid")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, HeapGrid)->Name("heap, grid")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, EngineGrid)->Name("engine, grid")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, EngineObserved)->Name("engine, observed grid")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, EngineTypes<1>)->Name("engine, grid of 1 type")->Arg(10'000);
BENCHMARK_TEMPLATE(closed_loop, EngineTypes<10>)->Name("engine, grid of 10 types")->Arg(10'000);
BENCHMARK_TEMPLATE(closed_loop, EngineTypes<100>)->Name("engine, grid of 100 types")->Arg(10'000);
BENCHMARK_TEMPLATE(closed_loop, EngineDistinct)->Name("engine, distinct")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, EngineRich)->Name("engine, rich")->Arg(1'000)->Arg(10'000)->Arg(100'000);
BENCHMARK_TEMPLATE(closed_loop, EngineParts)->Name("engine, parts on tracks")->Arg(100)->Arg(1'000);
BENCHMARK_TEMPLATE(closed_loop, HandParts)->Name("by hand, parts on tracks")->Arg(100)->Arg(1'000);
BENCHMARK(idle)->Name("engine, idle advance_to")->Arg(1'000)->Arg(100'000);
BENCHMARK(save_and_restore)->Name("engine, save and restore")->Arg(100'000);
BENCHMARK(copy_there_and_back)->Name("a plain copy there and back")->Arg(5'000'000);
BENCHMARK_TEMPLATE(memory, TwoStatePlant)->Name("memory of a plain unit")->Arg(10'000)->Arg(100'000)->Iterations(1);
BENCHMARK_TEMPLATE(memory, RichPlant)->Name("memory of a rich unit")->Arg(10'000)->Arg(100'000)->Iterations(1);

}  // namespace
}  // namespace symplant::bench
