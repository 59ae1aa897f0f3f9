// The time of the tool for a list: read + parse + derive + lower, the checks, the code generation.
#include <benchmark/benchmark.h>

#include <ctime>
#include <sstream>

#include "app/pipeline.hpp"
#include "bench/list_text.hpp"
#include "bench/loops.hpp"
#include "bench/rich_files.hpp"
#include "check/catalogue.hpp"
#include "emit/emit.hpp"
#include "lower/lower.hpp"
#include "model/derive.hpp"
#include "name/named_table.hpp"
#include "naming/load.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::bench {
namespace {

test::MemoryFileSystem files_with(std::int64_t rows) {
  test::MemoryFileSystem files;
  files.files["list.csv"] = list_text(static_cast<int>(rows / 4), 10);
  return files;
}

app::Compiled compiled(const test::MemoryFileSystem& files) {
  diag::Diagnostics diagnostics;
  std::ostringstream err;
  app::Progress progress(err, false);
  return std::move(*app::compile({"list.csv", {}, {}}, files, progress, diagnostics));
}

void read_parse_derive_lower(benchmark::State& state) {
  const auto files = files_with(state.range(0));
  for (auto _ : state) {
    diag::Diagnostics diagnostics;
    const auto list = std::make_shared<const read::SymbolTable>(
        std::move(*read::read_symbol_list("list.csv", {}, files, diagnostics)));
    const auto reader = std::make_shared<name::SymbolReader>(naming::strict_naming());
    std::vector<model::ListInput> lists;
    lists.push_back({list, name::read_names(*list, *reader)});
    const auto plant = model::describe(model::derive(lists, "list", reader), nullptr).plant;
    benchmark::DoNotOptimize(lower::lower(plant));
  }
  state.counters["ns_a_row"] =
      benchmark::Counter(static_cast<double>(state.range(0)) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void check(benchmark::State& state) {
  const auto files = files_with(state.range(0));
  const app::Compiled plant = compiled(files);
  for (auto _ : state) {
    diag::Diagnostics diagnostics;
    check::check_plant(plant.plant, plant.evidence, diagnostics);
    benchmark::DoNotOptimize(diagnostics);
  }
}

void generate(benchmark::State& state) {
  const auto files = files_with(state.range(0));
  const app::Compiled plant = compiled(files);
  class Counter final : public base::TextSink {
   public:
    void put(std::string_view part) override { bytes += part.size(); }
    std::size_t bytes = 0;
  } counter;
  for (auto _ : state) {
    for (const emit::EmittedFile& file : emit::emit(plant.plant, plant.tables, {}, files).files) file.content(counter);
  }
  benchmark::DoNotOptimize(counter.bytes);
}

/// The engine on a plant from files; compare it with the load rich of bench_engine.
void rich_from_files(benchmark::State& state) {
  EngineScan<RichFiles> loop(static_cast<std::uint32_t>(state.range(0)));
  std::int64_t motions = 0;
  const std::clock_t start = std::clock();
  for (auto _ : state) motions += loop.step();
  const double spent = static_cast<double>(std::clock() - start) * (1e9 / CLOCKS_PER_SEC);
  state.counters["ns_a_motion"] = spent / static_cast<double>(motions);
}

BENCHMARK(read_parse_derive_lower)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(rich_from_files)->Arg(10'000);
BENCHMARK(check)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(generate)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace symplant::bench
