// Explanations that a user asks for with `--why`.
#include "symplant/host/why.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "symplant/host/words.hpp"
#include "symplant/tables/lists.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::host {
namespace {

/// The symbols that a scenario sets or forces.
std::set<std::uint32_t> symbols_set(const scenario::Scenario& scenario) {
  std::set<std::uint32_t> symbols;
  for (const scenario::Step& step : scenario.steps) {
    for (const scenario::SymbolValue& value : step.set) symbols.insert(value.symbol);
    for (const scenario::SymbolValue& value : step.force) symbols.insert(value.symbol);
  }
  return symbols;
}

/// The end of a run.
class EndView final : public why::RecordedView {
 public:
  EndView(const Stage& stage, const RunKnowledge& knowledge)
      : RecordedView(stage.history, stage.plant.now(), &stage.plant), stage_(stage), knowledge_(knowledge) {
    if (knowledge.scenario != nullptr) set_ = symbols_set(*knowledge.scenario);
  }

  std::string unwritten(std::uint32_t operation) const override {
    if (set_.contains(operation)) return {};
    if (!knowledge_.carried[operation]) {
      if (!knowledge_.links.empty()) return "no link carries it";
      return knowledge_.scenario != nullptr ? "no step of the scenario sets it" : "nothing writes it in this run";
    }
    const std::uint32_t controller = tables::controller_of(stage_.plant.tables(), operation);
    const auto link = std::find_if(knowledge_.links.begin(), knowledge_.links.end(),
                                   [controller](const OpenLink& open) { return open.carries == controller; });
    if (link == knowledge_.links.end() || link->link->state() == exec::LinkState::live) return {};
    return fmt::format("its link {} {}", link->text(),
                       link->link->state() == exec::LinkState::lost ? "is lost" : "still waits for its PLC");
  }

  std::string violated(std::uint32_t requirement) const override {
    const Violation& violation = stage_.report.violation(requirement);
    if (violation.count == 0) return {};
    return fmt::format("was violated {} {}",
                       violation.count == 1 ? "at" : fmt::format("{} times, first at", violation.count),
                       trace::seconds(violation.first));
  }

  std::string standstill() const override {
    for (const OpenLink& open : knowledge_.links) {
      if (!open.link->freezes_plant()) continue;
      return fmt::format("the plant is frozen, since link {} {}", open.text(),
                         open.link->state() == exec::LinkState::lost ? "is lost" : "still waits for its PLC");
    }
    return {};
  }

 private:
  const Stage& stage_;
  const RunKnowledge& knowledge_;
  std::set<std::uint32_t> set_;
};

}  // namespace

std::optional<std::vector<Question>> questions_of(const std::vector<std::string>& named, const trace::PlantNames& names,
                                                  std::ostream& err) {
  std::vector<Question> questions;
  for (const std::string& name : named) {
    questions.push_back({name, why::things_named(name, names)});
    if (!questions.back().things.empty()) continue;
    const std::string nearest = why::nearest_thing(name, names);
    err << fmt::format("error: `{}` of `--why` not found; {}\n", shown(name),
                       nearest.empty() ? "name a device, symbol, requirement, track, place, transfer, work or source"
                                       : "did you mean `" + shown(nearest) + "`?");
    questions.pop_back();
  }
  if (questions.size() != named.size()) return std::nullopt;
  return questions;
}

std::vector<Answer> answers_to(std::span<const Question> questions, const Stage& stage, const RunKnowledge& knowledge) {
  const EndView view(stage, knowledge);
  std::vector<Answer> answers;
  for (const Question& question : questions) {
    for (const why::Reference& thing : question.things) {
      answers.push_back({why::name_of(thing, stage.explainer.names()), stage.explainer.why(thing, view)});
    }
  }
  return answers;
}

std::string answers_text(std::span<const Answer> answers) {
  std::string text;
  for (const Answer& answer : answers) {
    text += "why: ";
    for (const std::string& line : why::lines_of(answer.explanation)) text += shown(line) + "\n";
  }
  return text;
}

std::string answers_json(std::span<const Answer> answers, const trace::PlantNames& names) {
  std::string text;
  for (const Answer& answer : answers) {
    text += fmt::format(R"({}{{"of":{},{})", text.empty() ? "" : ",", trace::json_string(answer.name),
                        why::json_of(answer.explanation, names).substr(1));
  }
  return "[" + text + "]";
}

}  // namespace symplant::host
