// The state of a panel: what follows when the thread of the plant has carried out an order.
#include <utility>

#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/scenario/run_view.hpp"
#include "symplant/scenario/step_text.hpp"

namespace symplant::panel {
/// The plant is done with an order.
std::optional<SetBack> Desk::done(Pending& pending, const trace::Record& note) {
  Group& group = *pending.group;
  group.time = note.time;
  std::optional<SetBack> back;
  if ((note.value & kTooLate) != 0) {
    group.error = kTooLateText;
  } else if ((note.value & kDoesNotFit) != 0) {
    group.error = "the snapshot does not fit this plant";
  } else {
    back = carried_out(pending, note);
  }
  --group.waiting;
  finish(pending.group);
  return back;
}

std::optional<SetBack> Desk::carried_out(Pending& pending, const trace::Record& note) {
  const auto log_control = [&](const std::string& members) {
    log(note.time, note.value >> scenario::kTurnBits, "hand", members, false);
  };
  std::optional<SetBack> back;
  switch (pending.purpose) {
    case Purpose::act:
      acted(pending, note);
      break;
    case Purpose::control:
      if (pending.order.kind == Order::Kind::reset) back = set_back(pending, note.time);
      log_control(pending.name);
      break;
    case Purpose::restore:
      back = set_back(pending, note.time);
      log_control(fmt::format("\"restore\":{}", trace::json_string(pending.name)));
      break;
    case Purpose::play:
      play(pending, note.time);
      log_control(pending.name);
      break;
    case Purpose::snapshot:
    case Purpose::save:
    case Purpose::backtrack:
    case Purpose::why:
      copied(pending, note.time);
      break;
  }
  return back;
}

/// Steps acted on the plant; what was refused is not logged.
void Desk::acted(const Pending& pending, const trace::Record& note) {
  for (std::size_t i = 0; i < pending.steps.size(); ++i) {
    const scenario::Step step = refusals_.done_of(pending.steps[i], i);
    const std::string actions = scenario::actions_json(step, setup_.names);
    if (!actions.empty()) log(note.time, note.value >> scenario::kTurnBits, "hand", actions, true);
    if (std::string act = scenario::act_json(step, setup_.names); !act.empty()) new_acts_.push_back(std::move(act));
  }
  if (!refusals_.empty()) pending.group->error = std::string(refusals_.words()) + "; the other acts were done";
}

/// The plant plays an exercise, or no scenario any more.
void Desk::play(Pending& pending, tables::Time time) {
  player_ = std::move(pending.player);  // the plant has let go of the former one
  if (pending.exercise != nullptr) {
    exercise_ = std::move(pending.exercise);
    exercise_->begin(time);
    playing_ = &exercise_->scenario();
  } else {
    if (exercise_ != nullptr) exercise_->end(time);
    playing_ = nullptr;
  }
  played_.begin(nullptr);
}

std::optional<SetBack> Desk::set_back(const Pending& pending, tables::Time time) {
  const bool is_reset = pending.state == nullptr;
  if (is_reset) {
    shadow().reset(setup_.seed, setup_.cycle);
    is_exercise() ? exercise_->begin(time) : played_.begin(playing_);
  } else {
    go_back_to(pending);
  }
  setup_.history.load(shadow());
  picture_.load(shadow());
  chart_.set_back(time);
  forget_findings(is_reset ? -1 : time);
  begun_again_ = true;
  last_change_ = -1;
  session_.begin_again(pending.state);
  last_backtrack_ = time;
  return SetBack{is_reset ? "reset" : "restored", pending.state == nullptr ? std::string() : pending.name, time};
}

/// A restore: an exercise goes on as it was in that state. If the state has none of this play, the scenario is over.
void Desk::go_back_to(const Pending& pending) {
  shadow().restore(pending.state->snapshot.block);
  if (pending.order.played == nullptr) {
    if (exercise_ != nullptr) exercise_->end(pending.asked);
    playing_ = nullptr;
    played_.begin(nullptr);
  } else if (pending.state->exercise) {
    exercise_->go_back_to(*pending.state->exercise);
  }
  played_.forget();
}

/// A copy of the state has arrived.
void Desk::copied(Pending& pending, tables::Time time) {
  pending.state->snapshot.time = time;
  if (pending.state->played && is_exercise()) pending.state->exercise = exercise_->progress();
  Group& group = *pending.group;
  if (pending.purpose == Purpose::backtrack) return snapshots_.keep_backtrack(std::move(pending.state));
  if (pending.purpose == Purpose::why) {
    shadow().restore(pending.state->snapshot.block);
    group.body = explain(pending.name, time);
    return;
  }
  if (pending.purpose == Purpose::save) {
    group.error = trace::write_snapshot(snapshots_.path(pending.name, ".snapshot"), setup_.names.tables().name,
                                        pending.state->snapshot);
    if (group.error.empty()) snapshots_.has_file(pending.name);
  } else {
    group.error = snapshots_.keep(pending.name, std::move(pending.state));
  }
  const char* const key = pending.purpose == Purpose::save ? "save" : "snapshot";
  if (group.error.empty()) log(time, 0, "hand", fmt::format("\"{}\":{}", key, trace::json_string(pending.name)), false);
}

/// The answer to `why`: the shadow has the state.
std::string Desk::explain(const std::string& name, tables::Time time) {
  const scenario::RunView view(setup_.names, setup_.history, time, &shadow(),
                               {.links = link_states_ ? link_states_() : std::vector<exec::LinkState>(),
                                .carried = setup_.carried,
                                .scenario = playing_,
                                .frozen_at_panel = operator_.frozen(),
                                .violations = [&](std::uint32_t requirement) {
                                  const Violation& violation = violations_[requirement];
                                  return scenario::Violations{violation.count, violation.first};
                                }});
  std::string text;
  std::string trees;
  for (const why::Reference& thing : why::things_named(name, setup_.names)) {
    const why::Explanation explanation = setup_.explainer.why(thing, view);
    for (const std::string& line : why::lines_of(explanation)) text += line + "\n";
    trees += (trees.empty() ? "" : ",") + why::json_of(explanation, setup_.names);
  }
  std::string json = "{";
  put_member(json, "text", text);
  return json + ",\"trees\":[" + trees + "]}";
}

}  // namespace symplant::panel
