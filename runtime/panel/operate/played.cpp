// The scenario that plays, for the page.
#include "symplant/panel/operate/played.hpp"

#include <algorithm>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/scenario/step_words.hpp"
#include "symplant/scenario/verdict.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::panel {

std::string step_words(const scenario::Scenario& scenario, std::size_t step, const trace::PlantNames& names) {
  const scenario::Step& of = scenario.steps[step];
  if (of.expect) {
    return (of.when == scenario::Step::When::wait ? "wait: " : "expect: ") + scenario::expectation_words(of, names);
  }
  std::string actions = scenario::actions_words(of, names);
  if (!actions.empty()) return actions;
  return (of.when == scenario::Step::When::plus ? "wait " : "wait until ") + trace::seconds(of.time);
}

void Played::begin(const scenario::Scenario* scenario) {
  scenario_ = scenario;
  done_ = 0;
  known_ = true;
  over_ = false;
  ++version_;
}

void Played::step_done(std::size_t step) {
  done_ = step + 1;
  known_ = true;
  ++version_;
}

void Played::over() {
  over_ = true;
  ++version_;
}

void Played::forget() {
  known_ = false;
  over_ = false;
  ++version_;
}

std::string Played::next() const {
  const bool may_repeat = std::any_of(scenario_->repeats.begin(), scenario_->repeats.end(),
                                      [&](const scenario::Repeat& repeat) { return repeat.end == done_; });
  const bool none = over_ || !known_ || may_repeat || done_ == scenario_->steps.size();
  return none ? "" : step_words(*scenario_, done_, names_);
}

void Played::put(std::string& json, Role role) const {
  if (scenario_ == nullptr) {
    json += "null";
    return;
  }
  json += '{';
  put_member(json, "name", name_);
  panel::put(json, R"(,"done":{},"steps":{},"over":{})", known_ ? std::to_string(done_) : "null",
             scenario_->steps.size(), over_);
  put_member(json, "next", sees_all(role) ? next() : std::string());
  json += '}';
}

}  // namespace symplant::panel
