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
#include "symplant/why/malfunction_words.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::scenario {
namespace {

using trace::seconds;

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
                        trace::value_text(names.tables().symbols[value.symbol], value.value));
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

/// By symbol: the step that forces it, in words.
using Forces = std::map<std::uint32_t, std::string>;

/// The symbols forced after the steps up to and including `step`, done `turn` times before.
Forces forces_at(const Scenario& scenario, std::size_t step, std::uint64_t turn) {
  Forces forces;
  const auto play = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Step& done = scenario.steps[i];
      for (const SymbolValue& value : done.force) forces[value.symbol] = line_words(scenario, done);
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
why::Explanation hand_failure(const Scenario& scenario, const Failure& failure, const why::Explainer& explainer,
                              const why::StateView& view) {
  const trace::PlantNames& names = explainer.names();
  const Step& step = scenario.steps[failure.step];
  why::Explanation result;
  std::set<std::uint32_t> locations;
  for (const std::uint64_t hand : failure.hands) {
    const std::string_view before = result.sentence.empty() ? "" : ", ";
    if (hand >= kStartNote) {
      result.sentence += fmt::format("{}malfunction `{}` cannot start at {}: {} ordinary ones are active", before,
                                     names.malfunction(step.start[hand - kStartNote]), seconds(failure.time),
                                     tables::kMostOrdinaryMalfunctions);
    } else if (hand >= kTakeNote) {
      const tables::PartLocation& from = step.take[hand - kTakeNote];
      result.sentence +=
          fmt::format("{}no part to take at {} at {}", before, taken_from(from, names), seconds(failure.time));
      locations.insert(from.location);
    } else {
      const NewPart& put = step.put[hand];
      result.sentence += fmt::format("{}no room for a part of kind `{}` at {} at {}", before, names.part_kind(put.kind),
                                     location_text(put.at, names), seconds(failure.time));
      locations.insert(put.at.location);
    }
  }
  for (const std::uint32_t location : locations) {
    result.because.push_back(explainer.why({why::Reference::Kind::location, location}, view));
  }
  return result;
}

/// The state at the time of a failure. A forced symbol names the step that forces it.
class FailureView final : public why::RecordedView {
 public:
  FailureView(const trace::History& history, tables::Time time, const plant::Plant* plant, Forces forces)
      : RecordedView(history, time, plant), forces_(std::move(forces)) {}

  std::string forced(std::uint32_t symbol) const override {
    const auto force = forces_.find(symbol);
    return force == forces_.end() ? std::string() : "in " + force->second;
  }

 private:
  Forces forces_;
};

/// An expected value as a condition.
condition::Tree tree_of(const SymbolValue& wanted, tables::DataType type) {
  condition::Tree tree;
  tree.kind = condition::Tree::Kind::atom;
  tree.atom.of = wanted.symbol;
  if (type == tables::DataType::boolean) {
    tree.atom.kind = condition::Atom::Kind::bit;
    if (wanted.value != 0) return tree;
    condition::Tree negation;
    negation.kind = condition::Tree::Kind::negation;
    negation.children.push_back(std::move(tree));
    return negation;
  }
  tree.atom.kind = condition::Atom::Kind::number;
  tree.atom.number = trace::is_real(type)     ? tables::NumberKind::real
                     : trace::is_signed(type) ? tables::NumberKind::signed_integer
                                              : tables::NumberKind::unsigned_integer;
  tree.atom.operand = wanted.value;
  return tree;
}

}  // namespace

Verdict verdict_of(const Scenario& scenario, std::span<const Outcome> outcomes) {
  Verdict verdict;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!scenario.steps[i].is_checked()) continue;
    if (scenario.steps[i].expect) verdict.held += outcomes[i].done - outcomes[i].failed;
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

why::Explanation failure_words(const Scenario& scenario, const Failure& failure, const why::Explainer& explainer,
                               const trace::History& history, const plant::Plant* plant) {
  const trace::PlantNames& names = explainer.names();
  const Step& step = scenario.steps[failure.step];
  const FailureView view(history, failure.time, plant, forces_at(scenario, failure.step, failure.turn));
  const std::string turn = turn_words(scenario, failure.step, failure.turn);
  why::Explanation result;
  if (!failure.hands.empty()) {
    result = hand_failure(scenario, failure, explainer, view);
  } else {
    const std::vector<SymbolValue> wrong = missing(*step.expect, names, history);
    result.sentence = step.when == Step::When::wait
                          ? fmt::format("waited {} for `{}`, still false at {}", seconds(step.time), step.expect->text,
                                        seconds(failure.time))
                          : fmt::format("expected {} at {}",
                                        wrong.empty() ? expectation_words(step, names) : values_text(wrong, names),
                                        seconds(failure.time));
    condition::Tree expected;
    expected.kind = condition::Tree::Kind::all;
    for (const SymbolValue& value : wrong) {
      expected.children.push_back(tree_of(value, names.tables().symbols[value.symbol].type()));
    }
    if (step.expect->condition) expected.children.push_back(*step.expect->condition);
    result.because = explainer.why_not(expected, view);
  }
  why::add_malfunctions(result, names, history.malfunctions());
  if (!turn.empty()) result.sentence += ", in " + turn;
  return result;
}

}  // namespace symplant::scenario
