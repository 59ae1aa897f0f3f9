// What reading a name costs: by the built-in rule's own parser, and by rules of naming.json.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "infer/infer.hpp"
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
      if (reader.read({name, {}, {}, {}}).is_read()) ++read;
    }
    if (read != names.size()) state.SkipWithError("a name was not read");
    benchmark::DoNotOptimize(read);
  }
  state.counters["per name"] =
      benchmark::Counter(kNames, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void read_levels(benchmark::State& state) {
  name::Naming naming;
  naming.separators = "_";
  naming.units = name::Units::device;
  naming.rules.push_back(rule_of("{line}_{process}_{device}_{direction}_{task}"));
  naming.rules[0].exact = true;
  naming.rules[0].fields = {{"direction", "", {{"I", name::Direction::event}, {"O", name::Direction::operation}}}};
  read_all(state, strict_names(), naming);
}
BENCHMARK(read_levels);

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

/// Stations of robots and clamps, as body-shop lists name them.
std::vector<std::string> station_names(std::size_t count) {
  std::vector<std::string> names;
  for (int station = 10; names.size() < count; ++station) {
    for (int robot = 1; robot < 5; ++robot) {
      for (int bit = 1; bit <= 16; ++bit) {
        names.push_back(fmt::format("Q S{}_Q_RB{}_PROG_SELECT_{}", station, robot, bit));
        names.push_back(fmt::format("I S{}_I_RB{}_PROG_ECHO_{}", station, robot, bit));
      }
    }
    for (int clamp = 0; clamp < 120; ++clamp) {
      const char* motion = clamp % 2 == 0 ? "ADV" : "RET";
      names.push_back(fmt::format("Q S{}_SOL_CLAMP{}_{}", station, clamp / 2, motion));
      names.push_back(fmt::format("I S{}_LS_CLAMP{}_{}1", station, clamp / 2, motion));
      names.push_back(fmt::format("I S{}_LS_CLAMP{}_{}2", station, clamp / 2, motion));
    }
    for (int button = 0; button < 30; ++button) names.push_back(fmt::format("I S{}_PB_{}_START", station, button));
  }
  names.resize(count);
  return names;
}

void inference(benchmark::State& state) {
  const std::vector<std::string> names = station_names(static_cast<std::size_t>(state.range(0)));
  std::vector<infer::Sample> samples;
  for (const std::string& name : names) {
    infer::Sample& sample = samples.emplace_back();
    sample.text.name = std::string_view(name).substr(2);
    sample.side = name.front() == 'Q' ? tables::Direction::operation : tables::Direction::event;
    sample.text.address = sample.side;
  }
  for ([[maybe_unused]] auto _ : state) {
    const infer::Proposal proposal = infer::infer(samples, {});
    if (proposal.score.paired_share() < 0.5) state.SkipWithError("less than half was paired");
  }
}
BENCHMARK(inference)->Arg(4'000)->Arg(64'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace symplant::bench
