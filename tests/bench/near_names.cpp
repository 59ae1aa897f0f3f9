// The cost of `check` with near-duplicate names in the worst case: every device name is one letter away from many
// others.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "check/catalogue.hpp"
#include "model/derive.hpp"
#include "name/named_table.hpp"
#include "naming/load.hpp"
#include "read/readers.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::bench {
namespace {

/// The i-th of 26^4 words that differ in up to four letters: each word has a hundred neighbors one letter away.
std::string word(std::int64_t i) {
  std::string text = "CLAMPINGJAW";
  for (const std::size_t at : {1U, 4U, 7U, 9U}) {
    text[at] = static_cast<char>('A' + i % 26);
    i /= 26;
  }
  return text;
}

/// `halves`: each device has only an operation or only an event, so that each is a candidate to belong to another.
std::string list_text(std::int64_t devices, bool halves) {
  std::string text = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
  for (std::int64_t i = 0; i < devices; ++i) {
    const std::string name = "VAR_GLOBAL,LINE_ST1_" + word(i);
    const std::string number = std::to_string(i);
    if (!halves || i % 2 == 0) text += name + "_O_ON,,%QX" + number + ",BOOL,\n";
    if (!halves || i % 2 != 0) text += name + "_I_ON,,%IX" + number + ",BOOL,\n";
  }
  return text;
}

model::Derived derived_of(const std::string& text) {
  test::MemoryFileSystem files;
  files.files["list.csv"] = text;
  diag::Diagnostics diagnostics;
  const auto list =
      std::make_shared<const read::SymbolTable>(std::move(*read::read_symbol_list("list.csv", {}, files, diagnostics)));
  const auto reader = std::make_shared<name::SymbolReader>(naming::strict_naming());
  std::vector<model::ListInput> lists;
  lists.push_back({list, name::read_names(*list, *reader)});
  return model::describe(model::derive(lists, "list", reader), nullptr);
}

void near_names(benchmark::State& state, bool halves) {
  const model::Derived derived = derived_of(list_text(state.range(0), halves));
  std::size_t found = 0;
  for (auto _ : state) {
    diag::Diagnostics diagnostics;
    check::check_plant(derived.plant, derived.evidence, diagnostics, 1);
    found = diagnostics.all().size();
  }
  state.counters["findings"] = static_cast<double>(found);
  state.SetComplexityN(state.range(0));
}

void near_names_whole(benchmark::State& state) { near_names(state, false); }
void near_names_halves(benchmark::State& state) { near_names(state, true); }

BENCHMARK(near_names_whole)->RangeMultiplier(4)->Range(4'000, 256'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(near_names_halves)->RangeMultiplier(4)->Range(4'000, 256'000)->Complexity()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace symplant::bench
