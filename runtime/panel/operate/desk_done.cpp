// The state of a panel: what follows when the thread of the plant has carried out an order.
#include <utility>

#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/scenario/run_view.hpp"
#include "symplant/scenario/step_text.hpp"

namespace symplant::panel {
namespace {

std::string_view failure_text(std::uint64_t note) {
  if ((note & kNoRoom) != 0) return "a part has no room there";
  return (note & kNoPart) != 0 ? "there is no part there" : "too many malfunctions are active";
}

}  // namespace

/// An order was carried out.
std::optional<SetBack> Desk::done(Pending& pending, const trace::Record& note) {
  const std::uint64_t turn = note.value >> scenario::kTurnBits;
  const bool failed = (note.value & kFailed) != 0;
  Group& group = *pending.group;
  group.time = note.time;
  std::optional<SetBack> back;
  switch (pending.purpose) {
    case Purpose::act:
      for (const scenario::Step& step : pending.steps) {
        log(note.time, turn, "hand", scenario::actions_json(step, setup_.names), true);
      }
      if (failed) group.error = std::string(failure_text(note.value)) + "; the other acts were done";
      break;
    case Purpose::control:
      if (pending.order.kind == Order::Kind::reset) back = set_back(pending, note.time);
      log(note.time, turn, "hand", pending.name, false);
      break;
    case Purpose::restore:
      if (failed) {
        group.error = "the snapshot does not fit this plant";
      } else {
        back = set_back(pending, note.time);
        log(note.time, turn, "hand", fmt::format("\"restore\":{}", trace::json_string(pending.name)), false);
      }
      break;
    case Purpose::play:
      player_ = std::move(pending.player);  // the plant has let go of the former one
      if (pending.exercise != nullptr) {
        exercise_ = std::move(pending.exercise);
        exercise_->begin(note.time);
        playing_ = &exercise_->scenario();
        played_.begin(nullptr);
      } else {
        if (exercise_ != nullptr && !exercise_->is_over()) exercise_->over(note.time);
        playing_ = nullptr;
        played_.begin(nullptr);
      }
      log(note.time, turn, "hand", pending.name, false);
      break;
    case Purpose::snapshot:
    case Purpose::save:
    case Purpose::backtrack:
    case Purpose::why:
      copied(pending, note.time);
      break;
  }
  --group.waiting;
  finish(pending.group);
  return back;
}

std::optional<SetBack> Desk::set_back(const Pending& pending, tables::Time time) {
  const bool is_reset = pending.state == nullptr;
  if (is_reset) {
    shadow().reset(setup_.seed, setup_.cycle);
    is_exercise() ? exercise_->begin(time) : played_.begin(playing_);
  } else {
    shadow().restore(pending.state->snapshot.block);
    if (pending.order.played == nullptr) {
      playing_ = nullptr;
      played_.begin(nullptr);
    }
    played_.forget();
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

/// A copy of the state has arrived.
void Desk::copied(Pending& pending, tables::Time time) {
  pending.state->snapshot.time = time;
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
