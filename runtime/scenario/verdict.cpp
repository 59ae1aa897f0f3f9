// What became of a scenario, in words.
#include "symplant/scenario/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "symplant/scenario/evaluate.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::scenario {
namespace {

using trace::seconds;

/// What an expectation looks at, each once.
struct Things {
  std::set<std::uint32_t> symbols;
  std::set<std::uint32_t> units;
};

void collect(const condition::Tree& tree, Things& things) {
  if (tree.kind == condition::Tree::Kind::atom) {
    const bool is_unit =
        tree.atom.kind == condition::Atom::Kind::settled || tree.atom.kind == condition::Atom::Kind::moving;
    (is_unit ? things.units : things.symbols).insert(tree.atom.of);
  }
  for (const condition::Tree& child : tree.children) collect(child, things);
}

std::string since(core::Time changed) { return changed == 0 ? "since the start" : "since " + seconds(changed); }

std::string values_text(std::span<const SymbolValue> values, const trace::PlantNames& names) {
  std::string text;
  for (const SymbolValue& value : values) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names.symbol(value.symbol),
                        trace::value_text(names.tables().symbols[value.symbol].type(), value.value));
  }
  return text;
}

/// The values of an expectation that are not there.
std::vector<SymbolValue> missing(const Expectation& expectation, const trace::PlantNames& names,
                                 const trace::History& history) {
  std::vector<SymbolValue> found;
  for (const SymbolValue& wanted : expectation.values) {
    const core::DataType type = names.tables().symbols[wanted.symbol].type();
    if (!equal_values(type, history.value(wanted.symbol), wanted.value)) found.push_back(wanted);
  }
  return found;
}

}  // namespace

Verdict verdict_of(const Scenario& scenario, std::span<const Outcome> outcomes) {
  Verdict verdict;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!scenario.steps[i].expect) continue;
    const Outcome::Kind kind = outcomes[i].kind;
    ++(kind == Outcome::Kind::held ? verdict.held : kind == Outcome::Kind::failed ? verdict.failed : verdict.unreached);
  }
  return verdict;
}

std::string expectation_words(const Step& step, const trace::PlantNames& names) {
  const Expectation& expectation = *step.expect;
  if (step.when == Step::When::wait) return fmt::format("`{}` within {}", expectation.text, seconds(step.time));
  return expectation.condition ? "`" + expectation.text + "`" : values_text(expectation.values, names);
}

std::string failure_words(const Step& step, core::Time time, const trace::PlantNames& names,
                          const trace::History& history) {
  const std::vector<SymbolValue> wrong = missing(*step.expect, names, history);
  Things things;
  std::string text = fmt::format(
      "expected {} at {}", wrong.empty() ? expectation_words(step, names) : values_text(wrong, names), seconds(time));
  if (step.when == Step::When::wait) {
    text = fmt::format("waited {} for `{}`, in vain until {}", seconds(step.time), step.expect->text, seconds(time));
  }
  for (const SymbolValue& value : wrong) things.symbols.insert(value.symbol);
  if (step.expect->condition) collect(*step.expect->condition, things);
  for (const std::uint32_t symbol : things.symbols) {
    const core::SymbolRow& row = names.tables().symbols[symbol];
    text += fmt::format("; {} is {} {}, {}", names.symbol(symbol), trace::value_text(row.type(), history.value(symbol)),
                        since(history.since(symbol)), trace::symbol_words(symbol, names));
    if (row.unit != core::kNoUnit) things.units.insert(row.unit);
  }
  for (const std::uint32_t unit : things.units) {
    text += fmt::format("; {} is in {} {}", names.unit(unit), trace::state_words(unit, names, history),
                        since(history.unit_since(unit)));
  }
  if (things.units.empty()) return text;
  const std::vector<std::uint32_t> units(things.units.begin(), things.units.end());
  const std::string operations = trace::operations_words(units, names, history);
  return text + (operations.empty() ? "; none of its operations has been on" : "; operations: " + operations);
}

}  // namespace symplant::scenario
