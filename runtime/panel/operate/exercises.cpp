// Exercises for trainees.
#include "symplant/panel/operate/exercises.hpp"

#include <algorithm>
#include <utility>

#include "symplant/panel/operate/played.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/scenario/step_text.hpp"
#include "symplant/scenario/verdict.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::panel {

Exercise::Exercise(const ExerciseFile& file, const trace::PlantNames& names)
    : file_(file), names_(names), states_(file.scenario->steps.size()), times_(states_.size()) {}

void Exercise::begin(tables::Time time) {
  std::fill(states_.begin(), states_.end(), State::pending);
  points_.clear();
  next_ = 0;
  score_ = 0;
  since_ = time;
  took_ = -1;
  ++version_;
}

void Exercise::add_points(tables::Time time, std::int64_t points, std::string text) {
  if (points == 0) return;
  score_ += points;
  points_.push_back({time, points, std::move(text)});
}

void Exercise::step_done(std::size_t step, bool failed, tables::Time time) {
  ++version_;
  const scenario::Step& done = scenario().steps[step];
  if (states_[step] != State::failed) states_[step] = failed ? State::failed : State::done;
  times_[step] = time;
  next_ = step + 1;
  if (done.is_checked() && !failed)
    add_points(time, scenario().exercise->for_expectation,
               done.text.empty() ? step_words(scenario(), step, names_) : done.text);
}

void Exercise::requirement_violated(std::uint32_t requirement, tables::Time time) {
  if (is_over()) return;
  ++version_;
  add_points(time, scenario().exercise->for_violation,
             fmt::format("requirement violated: {}", names_.requirement(requirement)));
}

void Exercise::over(tables::Time time) {
  ++version_;
  took_ = time - since_;
  const scenario::Exercise& rules = *scenario().exercise;
  if (took_ <= rules.within) add_points(time, rules.for_time, "within " + trace::seconds(rules.within));
}

/// The points for a run with everything right.
std::int64_t Exercise::most() const {
  const scenario::Exercise& rules = *scenario().exercise;
  std::int64_t expectations = 0;
  for (std::size_t i = 0; i < scenario().steps.size(); ++i) {
    if (scenario().steps[i].is_checked()) {
      expectations += static_cast<std::int64_t>(scenario::executions(scenario(), i));
    }
  }
  return rules.for_expectation * expectations + rules.for_time;
}

void Exercise::put(std::string& json) const {
  const scenario::Exercise& rules = *scenario().exercise;
  json += '{';
  put_member(json, "name", file_.name);
  put_member(json, "title", rules.title);
  put_member(json, "text", rules.text);
  panel::put(json, R"(,"state":"{}","step":{},"steps":[)", is_over() ? "over" : "running", next_);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const bool active = states_[i] == State::pending && i == next_ && !is_over();
    const char* const state = active                         ? "active"
                              : states_[i] == State::pending ? "pending"
                              : states_[i] == State::done    ? "done"
                                                             : "failed";
    put_comma(json);
    json += '{';
    put_member(json, "text", scenario().steps[i].text);
    put_member(json, "does", step_words(scenario(), i, names_));
    panel::put(json, R"(,"state":"{}","t":{}}})", state,
               states_[i] == State::pending ? "null" : std::to_string(times_[i]));
  }
  panel::put(json, R"(],"score":{},"most":{},"points":[)", score_, most());
  for (const Point& point : points_) {
    put_comma(json);
    panel::put(json, R"({{"t":{},"points":{})", point.time, point.points);
    put_member(json, "text", point.text);
    json += '}';
  }
  panel::put(json, R"(],"since":{},"took":{}}})", since_, is_over() ? std::to_string(took_) : "null");
}

void Exercise::add_cases(std::vector<trace::TestCase>& cases) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!scenario().steps[i].is_checked()) continue;
    const std::string& text = scenario().steps[i].text;
    const bool failed = states_[i] != State::done;
    const char* const failure = !failed ? "" : states_[i] == State::failed ? "it did not hold" : "it was not reached";
    cases.push_back({fmt::format("step {}: {}", i + 1, text.empty() ? step_words(scenario(), i, names_) : text),
                     times_[i], failure});
  }
  cases.push_back({fmt::format("score: {} of {}", score_, most()), since_ + std::max<tables::Time>(took_, 0), ""});
}

void put_exercises(std::string& json, const std::vector<ExerciseFile>& files) {
  put_key(json, "exercises");
  json += '[';
  for (const ExerciseFile& file : files) {
    put_comma(json);
    json += '{';
    put_member(json, "name", file.name);
    put_member(json, "title", file.scenario->exercise->title);
    put_member(json, "text", file.scenario->exercise->text);
    put(json, ",\"steps\":{}}}", file.scenario->steps.size());
  }
  json += ']';
}

}  // namespace symplant::panel
