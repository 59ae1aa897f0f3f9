// Explanations that a user asks for with `--why`.
#include "symplant/host/why.hpp"

#include <fmt/format.h>

#include <utility>

#include "symplant/host/words.hpp"
#include "symplant/scenario/run_view.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::host {

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
  const trace::PlantNames& names = stage.explainer.names();
  scenario::RunFacts facts{.carried = knowledge.carried,
                           .scenario = knowledge.scenario,
                           .frozen_at_panel = knowledge.frozen_at_panel,
                           .violations = [&](std::uint32_t requirement) {
                             const Violation& violation = stage.report.violation(requirement);
                             return scenario::Violations{violation.count, violation.first};
                           }};
  for (const OpenLink& open : knowledge.links) facts.links.push_back(open.link->state());
  const scenario::RunView view(names, stage.history, stage.plant.now(), &stage.plant, std::move(facts));
  std::vector<Answer> answers;
  for (const Question& question : questions) {
    for (const why::Reference& thing : question.things) {
      answers.push_back({why::name_of(thing, names), stage.explainer.why(thing, view)});
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
