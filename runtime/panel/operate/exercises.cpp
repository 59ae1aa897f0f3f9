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

Exercise::Exercise(const ExerciseFile& file, const trace::PlantNames& names) : file_(file), names_(names) { begin(0); }

void Exercise::begin(tables::Time time) {
  const std::size_t steps = scenario().steps.size();
  progress_ = {};
  progress_.states.resize(steps);
  progress_.times.resize(steps);
  progress_.turns.resize(steps);
  progress_.since = time;
  ++version_;
}

void Exercise::go_back_to(const Progress& progress) {
  progress_ = progress;
  ++version_;
}

void Exercise::add_points(tables::Time time, std::int64_t points, std::string text) {
  if (points == 0) return;
  progress_.score += points;
  progress_.points.push_back({time, points, std::move(text)});
}

void Exercise::step_done(std::size_t step, bool failed, tables::Time time) {
  ++version_;
  const scenario::Step& done = scenario().steps[step];
  if (progress_.states[step] != State::failed) progress_.states[step] = failed ? State::failed : State::done;
  progress_.times[step] = time;
  ++progress_.turns[step];
  progress_.next = step + 1;
  if (done.expect && !failed)
    add_points(time, scenario().exercise->for_expectation,
               done.text.empty() ? step_words(scenario(), step, names_) : done.text);
}

void Exercise::requirement_violated(std::uint32_t requirement, tables::Time time) {
  if (is_over()) return;
  ++version_;
  add_points(time, scenario().exercise->for_violation,
             fmt::format("requirement violated: {}", names_.requirement(requirement)));
}

void Exercise::end(tables::Time time) {
  if (is_over()) return;
  ++version_;
  progress_.took = time - progress_.since;
}

void Exercise::over(tables::Time time) {
  if (is_over()) return;
  end(time);
  const scenario::Exercise& rules = *scenario().exercise;
  if (progress_.took <= rules.within) add_points(time, rules.for_time, "within " + trace::seconds(rules.within));
}

/// The points for a run with everything right.
std::int64_t Exercise::most() const {
  const scenario::Exercise& rules = *scenario().exercise;
  std::int64_t expectations = 0;
  for (std::size_t i = 0; i < scenario().steps.size(); ++i) {
    if (scenario().steps[i].expect) {
      expectations += static_cast<std::int64_t>(scenario::executions(scenario(), i));
    }
  }
  return rules.for_expectation * expectations + rules.for_time;
}

void Exercise::put_step(std::string& json, std::size_t step, Role role) const {
  const State of = progress_.states[step];
  const bool active = of == State::pending && step == progress_.next && !is_over();
  const char* const state = active                 ? "active"
                            : of == State::pending ? "pending"
                            : of == State::done    ? "done"
                                                   : "failed";
  put_comma(json);
  json += '{';
  const bool is_shown = sees_all(role) || step <= progress_.next;
  put_member(json, "text", is_shown ? scenario().steps[step].text : std::string());
  if (sees_all(role)) put_member(json, "does", step_words(scenario(), step, names_));
  panel::put(json, R"(,"state":"{}","t":{}}})", state,
             of == State::pending ? "null" : std::to_string(progress_.times[step]));
}

void Exercise::put_score(std::string& json) const {
  panel::put(json, R"(,"score":{},"most":{},"points":[)", progress_.score, most());
  for (const Point& point : progress_.points) {
    put_comma(json);
    panel::put(json, R"({{"t":{},"points":{})", point.time, point.points);
    put_member(json, "text", point.text);
    json += '}';
  }
  json += ']';
}

void Exercise::put(std::string& json, Role role) const {
  const scenario::Exercise& rules = *scenario().exercise;
  json += '{';
  put_member(json, "name", file_.name);
  put_member(json, "title", rules.title);
  put_member(json, "text", rules.text);
  panel::put(json, R"(,"state":"{}","step":{},"steps":[)", is_over() ? "over" : "running", progress_.next);
  for (std::size_t i = 0; i < progress_.states.size(); ++i) put_step(json, i, role);
  json += ']';
  if (sees_all(role) || rules.shows_score) put_score(json);
  panel::put(json, R"(,"since":{},"took":{}}})", progress_.since, is_over() ? std::to_string(progress_.took) : "null");
}

const char* Exercise::failure_of(std::size_t step) const {
  if (progress_.states[step] == State::failed) return "it did not hold";
  return progress_.turns[step] < scenario::executions(scenario(), step) ? "it was not reached" : "";
}

void Exercise::add_cases(std::vector<trace::TestCase>& cases) const {
  for (std::size_t i = 0; i < progress_.states.size(); ++i) {
    const scenario::Step& step = scenario().steps[i];
    const std::string failure = failure_of(i);
    if (!step.expect && (failure.empty() || !step.is_checked())) continue;
    const std::string& text = step.text;
    cases.push_back({fmt::format("step {}: {}", i + 1, text.empty() ? step_words(scenario(), i, names_) : text),
                     progress_.times[i], failure});
  }
  cases.push_back({fmt::format("score: {} of {}", progress_.score, most()),
                   progress_.since + std::max<tables::Time>(progress_.took, 0), ""});
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
