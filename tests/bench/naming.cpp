// What reading a name costs: by the built-in rule's own parser, and by rules of naming.json.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "name/name_parser.hpp"
#include "name/symbol_reader.hpp"

namespace symplant::bench {
namespace {

constexpr int kNames = 100'000;

std::vector<std::string> strict_names() {
  std::vector<std::string> names;
  for (int i = 0; i < kNames; ++i) {
    names.push_back(fmt::format("LINE{}_P{}_DEV{}_{}_ADV", i / 10000, i / 100, i / 4, i % 2 == 0 ? 'I' : 'O'));
  }
  return names;
}

std::vector<std::string> body_names() {
  std::vector<std::string> names;
  for (int i = 0; i < kNames; ++i) {
    names.push_back(fmt::format("S{}{}_{}_{}_{}", 100 + i / 500, i % 3 == 0 ? "LH" : "", i % 2 == 0 ? "SOL" : "WRS",
                                fmt::format("{}ST_CLAMP{}", i % 7, i / 4), i % 4 < 2 ? "ADV" : "RET1"));
  }
  return names;
}

name::SymbolRule rule_of(std::string pattern) {
  name::SymbolRule rule;
  rule.patterns.push_back({name::Source::name, std::move(pattern)});
  return rule;
}

void read_all(benchmark::State& state, const std::vector<std::string>& names, name::Naming naming) {
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(std::move(naming), faults);
  for ([[maybe_unused]] auto _ : state) {
    name::SymbolReader reader(compiled);
    std::size_t read = 0;
    for (const std::string& name : names) {
      if (reader.read({name, {}, {}, {}}).outcome == name::Outcome::read) ++read;
    }
    if (read != names.size()) state.SkipWithError("a name was not read");
    benchmark::DoNotOptimize(read);
  }
  state.counters["per name"] =
      benchmark::Counter(kNames, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void built_in_parser(benchmark::State& state) {
  const std::vector<std::string> names = strict_names();
  name::NameParser parser(name::built_in_rule());
  for ([[maybe_unused]] auto _ : state) {
    for (const std::string& name : names) benchmark::DoNotOptimize(parser.parse(name));
  }
  state.counters["per name"] =
      benchmark::Counter(kNames, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(built_in_parser);

void strict_as_rule(benchmark::State& state) {
  name::Naming naming;
  naming.separators = "_";
  naming.rules.push_back(rule_of("{line}_{process}_{device}_{direction}_{task}"));
  read_all(state, strict_names(), naming);
}
BENCHMARK(strict_as_rule);

void cylinders(benchmark::State& state) {
  name::Naming naming;
  naming.rules.push_back(rule_of("{process}_{direction}_{device}_{task...}"));
  naming.rules.push_back(rule_of("{process}_{device...}_(PL|PB|SW|LAMP)_{task...}"));
  naming.rules.push_back(rule_of("{process}_{class}_{device...}_{task:known}"));
  read_all(state, body_names(), naming);
}
BENCHMARK(cylinders);

void cylinders_with_expressions(benchmark::State& state) {
  name::Naming naming;
  naming.normalise.replace = {{"_WRS_([0-9])_C_", "_WRS_$1ST_C_"}};
  naming.ignore = {"SPARE*", "*RESERVE*"};
  naming.rules.push_back(rule_of("{process}_{direction}_{device}_{task...}"));
  naming.rules.push_back(rule_of("{process}_{class}_{device...}_{task:known}"));
  naming.rules[1].fields.push_back({"process", "S[0-9]{3}(LH|RH)?", {}});
  read_all(state, body_names(), naming);
}
BENCHMARK(cylinders_with_expressions);

}  // namespace
}  // namespace symplant::bench
