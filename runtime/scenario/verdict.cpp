// Describes the outcome of a scenario.
#include "symplant/scenario/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "symplant/scenario/evaluate.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::scenario {
namespace {

using trace::seconds;

/// The symbols, units and locations of parts of an expectation, each once.
struct Things {
  std::set<std::uint32_t> symbols;
  std::set<std::uint32_t> units;
  std::set<std::uint32_t> locations;  ///< of parts
};

/// Collects the symbols and units of a condition that does not hold; of a conjunction only the parts that do not hold.
void collect(const condition::Tree& tree, const trace::History& history, Things& things) {
  if (tree.kind == condition::Tree::Kind::atom) {
    const bool is_unit =
        tree.atom.kind == condition::Atom::Kind::settled || tree.atom.kind == condition::Atom::Kind::moving;
    const bool is_location = tree.atom.kind == condition::Atom::Kind::parts;
    (is_location ? things.locations : is_unit ? things.units : things.symbols).insert(tree.atom.of);
  }
  for (const condition::Tree& child : tree.children) {
    if (tree.kind == condition::Tree::Kind::all && holds(child, history)) continue;
    collect(child, history, things);
  }
}

std::string location_text(const tables::PartLocation& at, const trace::PlantNames& names) {
  const std::string name(names.location(at.location));
  return at.at == tables::kWhole ? name : fmt::format("{}@{} mm", name, static_cast<double>(at.at) / 1000);
}

/// What a step does by hand.
std::string hand_words(const Step& step, const trace::PlantNames& names) {
  std::string text;
  for (const NewPart& part : step.put) {
    text += fmt::format("{}room for a `{}` at {}", text.empty() ? "" : ", ", names.part_kind(part.kind),
                        location_text(part.at, names));
  }
  for (const tables::PartLocation& at : step.take) {
    text += fmt::format("{}a part at {}", text.empty() ? "" : ", ", location_text(at, names));
  }
  for (const std::uint32_t malfunction : step.start) {
    text += fmt::format("{}malfunction `{}`", text.empty() ? "" : ", ", names.malfunction(malfunction));
  }
  return text;
}

std::string values_text(std::span<const SymbolValue> values, const trace::PlantNames& names) {
  std::string text;
  for (const SymbolValue& value : values) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", names.symbol(value.symbol),
                        trace::value_text(names.tables().symbols[value.symbol].type(), value.value));
  }
  return text;
}

/// The values of an expectation that do not hold.
std::vector<SymbolValue> missing(const Expectation& expectation, const trace::PlantNames& names,
                                 const trace::History& history) {
  std::vector<SymbolValue> found;
  for (const SymbolValue& wanted : expectation.values) {
    const tables::DataType type = names.tables().symbols[wanted.symbol].type();
    if (!equal_values(type, history.value(wanted.symbol), wanted.value)) found.push_back(wanted);
  }
  return found;
}

/// The step that forces a symbol.
struct Force {
  std::uint64_t value = 0;
  std::string line;  ///< in words
};
using Forces = std::map<std::uint32_t, Force>;

/// The symbols forced after the steps up to and including `step`, done `turn` times before.
Forces forces_at(const Scenario& scenario, std::size_t step, std::uint64_t turn) {
  Forces forces;
  const auto play = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Step& done = scenario.steps[i];
      for (const SymbolValue& value : done.force) forces[value.symbol] = {value.value, line_words(scenario, done)};
      for (const std::uint32_t symbol : done.release) forces.erase(symbol);
    }
  };
  std::vector<Repeat> before;  // around the step, with turns that are over; the outer one last
  for (const Repeat& repeat : scenario.repeats) {
    if (step < repeat.begin || step >= repeat.end) continue;
    if (turn % repeat.turns != 0) before.push_back(repeat);
    turn /= repeat.turns;
  }
  std::size_t from = 0;
  for (auto repeat = before.rbegin(); repeat != before.rend(); ++repeat) {
    play(from, repeat->end);
    from = repeat->begin;
  }
  play(from, step + 1);
  return forces;
}

/// Where a part is taken: without a position, from the end of a track.
std::string taken_from(const tables::PartLocation& from, const trace::PlantNames& names) {
  const bool end = from.at == tables::kWhole && from.location < names.tables().material.tracks.size();
  return (end ? "the end of " : "") + location_text(from, names);
}

/// The parts that had no room, or were not there to take.
std::vector<std::string> hand_parts(const Scenario& scenario, std::size_t at, std::uint64_t turn, tables::Time time,
                                    std::span<const std::uint64_t> hands, const trace::PlantNames& names,
                                    const trace::History& history) {
  const Step& step = scenario.steps[at];
  std::vector<std::string> parts;
  std::set<std::uint32_t> locations;
  for (const std::uint64_t hand : hands) {
    if (hand >= kStartNote) {
      parts.push_back(fmt::format("malfunction `{}` cannot start at {}: {} ordinary ones are active",
                                  names.malfunction(step.start[hand - kStartNote]), seconds(time),
                                  tables::kMostOrdinaryMalfunctions));
    } else if (hand >= kTakeNote) {
      const tables::PartLocation& from = step.take[hand - kTakeNote];
      parts.push_back(fmt::format("no part to take at {} at {}", taken_from(from, names), seconds(time)));
      locations.insert(from.location);
    } else {
      const NewPart& put = step.put[hand];
      parts.push_back(fmt::format("no room for a part of kind `{}` at {} at {}", names.part_kind(put.kind),
                                  location_text(put.at, names), seconds(time)));
      locations.insert(put.at.location);
    }
  }
  if (const std::string words = turn_words(scenario, at, turn); !words.empty()) parts.front() += ", in " + words;
  for (const std::uint32_t location : locations) parts.push_back(trace::location_words(location, names, history));
  return parts;
}

}  // namespace

Verdict verdict_of(const Scenario& scenario, std::span<const Outcome> outcomes) {
  Verdict verdict;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!scenario.steps[i].is_checked()) continue;
    verdict.held += outcomes[i].done - outcomes[i].failed;
    verdict.failed += outcomes[i].failed;
    verdict.unreached += executions(scenario, i) - outcomes[i].done;
  }
  return verdict;
}

std::string expectation_words(const Step& step, const trace::PlantNames& names) {
  if (!step.expect) return hand_words(step, names);
  const Expectation& expectation = *step.expect;
  if (step.when == Step::When::wait) return fmt::format("`{}` within {}", expectation.text, seconds(step.time));
  return expectation.condition ? "`" + expectation.text + "`" : values_text(expectation.values, names);
}

std::vector<std::string> failure_parts(const Scenario& scenario, std::size_t at, std::uint64_t turn, tables::Time time,
                                       std::span<const std::uint64_t> hands, const trace::PlantNames& names,
                                       const trace::History& history) {
  const Step& step = scenario.steps[at];
  if (!hands.empty()) return hand_parts(scenario, at, turn, time, hands, names, history);
  const Forces forces = forces_at(scenario, at, turn);
  const std::vector<SymbolValue> wrong = missing(*step.expect, names, history);
  std::vector<std::string> parts;
  if (step.when == Step::When::wait) {
    parts.push_back(
        fmt::format("waited {} for `{}`, still false at {}", seconds(step.time), step.expect->text, seconds(time)));
  } else {
    parts.push_back(fmt::format("expected {} at {}",
                                wrong.empty() ? expectation_words(step, names) : values_text(wrong, names),
                                seconds(time)));
  }
  if (const std::string words = turn_words(scenario, at, turn); !words.empty()) parts.front() += ", in " + words;
  Things things;
  for (const SymbolValue& value : wrong) things.symbols.insert(value.symbol);
  if (step.expect->condition) collect(*step.expect->condition, history, things);
  for (const std::uint32_t symbol : things.symbols) {
    const tables::SymbolRow& row = names.tables().symbols[symbol];
    const auto force = forces.find(symbol);
    parts.push_back(fmt::format(
        "{} has been {} {}{}, {}", names.symbol(symbol), trace::value_text(row.type(), history.value(symbol)),
        trace::since_words(history.since(symbol)), force == forces.end() ? "" : ", forced in " + force->second.line,
        trace::symbol_words(symbol, names)));
    if (row.unit != tables::kNone) things.units.insert(row.unit);
  }
  for (const std::uint32_t location : things.locations)
    parts.push_back(trace::location_words(location, names, history));
  for (const std::uint32_t unit : things.units) {
    parts.push_back(trace::unit_words(unit, names, history));
    for (const std::uint32_t symbol : names.symbols_of(unit)) {
      const auto force = forces.find(symbol);
      if (force == forces.end() || things.symbols.contains(symbol)) continue;
      parts.push_back(fmt::format("{} is forced to {} in {}", names.symbol(symbol),
                                  trace::value_text(names.tables().symbols[symbol].type(), force->second.value),
                                  force->second.line));
    }
  }
  for (std::string& words : trace::malfunction_words(names, history)) parts.push_back(std::move(words));
  return parts;
}

}  // namespace symplant::scenario
