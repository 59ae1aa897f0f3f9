// The state of a panel: records come in, orders are carried out, pictures go out.
#include "symplant/panel/operate/desk.hpp"

#include <algorithm>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/scenario/run_view.hpp"
#include "symplant/scenario/step_text.hpp"
#include "symplant/scenario/verdict.hpp"
#include "symplant/trace/hidden_malfunctions.hpp"
#include "symplant/trace/influences.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::panel {
namespace {

constexpr std::size_t kMostFindings = 200;

bool is_note(tables::FindingKind kind) {
  return kind == tables::FindingKind::started_on_enabling || kind == tables::FindingKind::link_back;
}

}  // namespace

Desk::Desk(Setup setup)
    : setup_(std::move(setup)),
      operator_(setup_.plant, setup_.recorder, setup_.player, setup_.programs, setup_.seed, setup_.cycle),
      picture_(setup_.names, setup_.history),
      chart_(setup_.names, setup_.history),
      alarm_sources_(setup_.names, setup_.history, setup_.view, setup_.plant.now(), alarms_),
      reader_(setup_.names, setup_.carried, setup_.history),
      snapshots_(setup_.folder, setup_.plant.save().size()),
      session_(setup_.names, setup_.seed),
      training_(setup_.names, setup_.history),
      allowed_(setup_.names, setup_.view),
      block_(setup_.plant.save().size()),
      violations_(setup_.names.tables().requirements.size()),
      playing_(setup_.scenario),
      played_(setup_.names, setup_.scenario_name),
      asked_player_(setup_.player),
      play_(setup_.player != nullptr ? 1 : 0),
      last_backtrack_(setup_.plant.now()) {
  take_outputs();
  if (setup_.player != nullptr) setup_.player->note_steps();
  if (playing_ != nullptr && playing_->exercise) {
    const std::shared_ptr<const scenario::Scenario> unowned(std::shared_ptr<void>(), playing_);
    exercise_ = std::make_shared<Exercise>(ExerciseFile{setup_.scenario_name, unowned}, setup_.names);
    exercise_->begin(setup_.plant.now());
    allow();
  } else {
    played_.begin(playing_);
  }
  if (!setup_.resumed.empty()) {
    picture_.load(setup_.plant);
    alarm_sources_.set_back(setup_.plant.now(), setup_.plant.now());
    training_.set_back(setup_.plant.now());
    session_.begin_again(std::make_shared<KeptState>(KeptState{trace::Snapshot::of(setup_.plant)}));
  }
}

plant::OwnedPlant& Desk::shadow() {
  if (!shadow_) shadow_.emplace(setup_.names.tables(), setup_.behaviours);
  return *shadow_;
}

void Desk::before(const trace::Record& record) {
  chart_.apply(record);
  alarm_sources_.before(record);
}

void Desk::after(const trace::Record& record) {
  picture_.apply(record);
  alarm_sources_.after(record);
  training_.apply(record);
  last_change_ = record.time;
  ++revision_;
}

std::optional<SetBack> Desk::note(const trace::Record& record) {
  ++revision_;
  if (record.of == scenario::kForceNote) {
    picture_.touch_symbol(static_cast<std::uint32_t>(record.value / 2));
  } else if (record.of == scenario::kTurnNote) {
    step_turn_ = record.value;
  } else if (record.of == scenario::kRefusedNote) {
    refusals_.add(record.value);
  } else if (record.of == scenario::kStepNote) {
    step_noted(record);
    refusals_.clear();
  } else if (record.of == kOverNote) {
    is_exercise() ? exercise_->over(record.time) : played_.over();
  } else if (record.of == kOrderNote) {
    const auto found = pending_.find(static_cast<std::uint32_t>(record.value % kLeastOutcome));
    if (found == pending_.end()) return std::nullopt;
    Pending pending = std::move(found->second);
    pending_.erase(found);
    std::optional<SetBack> back = done(pending, record);
    refusals_.clear();
    return back;
  }
  return std::nullopt;
}

void Desk::step_noted(const trace::Record& record) {
  const auto index = static_cast<std::size_t>(record.value & 0xFFFF'FFFF);
  if (playing_ == nullptr || index >= playing_->steps.size()) return;
  const std::string actions = scenario::actions_json(refusals_.done_of(playing_->steps[index], 0), setup_.names);
  if (!actions.empty()) log(record.time, record.value >> scenario::kTurnBits, "scenario", actions, true);
  const bool failed = (record.value & scenario::kStepFailed) != 0;
  if (failed) step_failed(index, record.time);
  is_exercise() ? exercise_->step_done(index, failed, record.time) : played_.step_done(index);
}

void Desk::step_failed(std::size_t step, tables::Time time) {
  const auto failure_words = [&] {
    return why::in_one_line(scenario::failure_words(*playing_, {step, step_turn_, time, refusals_.values()},
                                                    setup_.explainer, setup_.history, nullptr));
  };
  const std::string words = failure_words();
  const std::string name = fmt::format("step {}", step + 1);
  const trace::HiddenMalfunctions hidden(setup_.history);
  const bool is_of_plant = playing_->steps[step].expect && refusals_.empty();
  const std::string shown = is_of_plant ? failure_words() : std::string();
  add_finding({time, "", "", 0, tables::kNone, is_exercise() ? "" : name, words}, "expectation failed", name, "error",
              shown);
}

void Desk::log(tables::Time time, std::uint64_t turn, std::string_view by, const std::string& members, bool is_step,
               const std::string& name) {
  session_.add({time, turn, last_change_ == time, std::string(by), "{" + members + "}",
                is_step ? members : std::string(), name});
}

void Desk::finding(const trace::FoundThing& found, const std::string& words) {
  ++revision_;
  const bool violated = found.kind == tables::FindingKind::requirement_violated;
  if (violated) {
    Violation& violation = violations_[found.of.front()];
    violation.note(found.time);
    violation.changed = true;
    if (exercise_ != nullptr) exercise_->requirement_violated(found.of.front(), found.time);
  }
  const std::string shown = setup_.history.malfunctions().empty() && !trace::is_of_malfunctions(found, setup_.names)
                                ? words
                                : words_without_malfunctions(found);
  if (!shown.empty()) alarm_sources_.finding(found, shown);  // alarms are the same for all roles
  add_finding({found.time, "", "", 0, violated ? found.of.front() : tables::kNone, "", words},
              trace::finding_name(found.kind), trace::name_of(found, setup_.names),
              violated              ? "error"
              : is_note(found.kind) ? "note"
                                    : "warning",
              shown);
}

/// The words of a finding, for roles that do not see malfunctions; empty for a loop of malfunctions.
std::string Desk::words_without_malfunctions(const trace::FoundThing& found) {
  if (trace::is_of_malfunctions(found, setup_.names)) return {};
  if (found.kind == tables::FindingKind::command_to_a_disabled_unit) {
    const std::uint32_t unit = setup_.names.tables().symbols[found.of.front()].unit;
    if (!trace::is_disabled_by_device(unit, setup_.names, setup_.history)) return {};
  }
  const trace::HiddenMalfunctions hidden(setup_.history);
  if (found.kind != tables::FindingKind::requirement_violated) {
    return trace::finding_words(found, setup_.names, setup_.history);
  }
  const why::RecordedView view(setup_.history, found.time, nullptr);
  return why::in_one_line(setup_.explainer.violation(found.of.front(), view));
}

void Desk::add_finding(Found found, std::string_view kind, std::string_view of, std::string_view severity,
                       const std::string& shown) {
  const auto members = [&](const std::string& text) {
    std::string json;
    put(json, "\"t\":{}", found.time);
    put_member(json, "finding", kind);
    put_member(json, "of", of);
    put_member(json, "severity", severity);
    put_member(json, "text", text);
    return json;
  };
  found.json = members(found.text);
  if (!shown.empty()) {
    found.shown = shown == found.text ? found.json : members(shown);
    found.shown_number = shown_findings_++;
  }
  findings_.push_back(std::move(found));
  if (findings_.size() <= kMostFindings) return;
  findings_.pop_front();
  ++first_finding_;
}

void Desk::forget_findings(tables::Time after) {
  while (!findings_.empty() && findings_.back().time > after) {
    if (!findings_.back().shown.empty()) --shown_findings_;
    findings_.pop_back();
  }
  if (findings_.empty()) first_finding_ = shown_findings_ = 0;
  sent_findings_ = first_finding_ + findings_.size();
  std::fill(violations_.begin(), violations_.end(), Violation{});
  for (const Found& found : findings_) {
    if (found.requirement == tables::kNone) continue;
    violations_[found.requirement].note(found.time);
  }
}

/// What a trainee may operate in the exercise that is played.
void Desk::allow() {
  const scenario::Exercise* const rules = is_exercise() ? &*exercise_->scenario().exercise : nullptr;
  rules != nullptr && rules->allow ? allowed_.by_patterns(*rules->allow) : allowed_.by_default();
}

void Desk::look_at_time(tables::Time every) {
  take_outputs();
  const tables::Time now = operator_.now();
  if (now < last_backtrack_) last_backtrack_ = now;
  if (every == 0 || now < last_backtrack_ + every || operator_.frozen() || pending_.size() >= Operator::kMostOrders)
    return;
  last_backtrack_ = now;
  offer_copy(Purpose::backtrack, "", std::make_shared<Group>());
}

void Desk::end() {
  ended_ = true;
  for (auto& [id, pending] : pending_) {
    pending.group->waiting = 0;
    pending.group->error = "the run has ended";
    finish(pending.group);
  }
  pending_.clear();
}

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
    log(note.time, note.value >> scenario::kTurnBits, "hand", members, false, pending.group->sender.name);
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
    const std::string_view by = name_of_hand(pending.group->sender.role);
    if (!actions.empty()) {
      log(note.time, note.value >> scenario::kTurnBits, by, actions, true, pending.group->sender.name);
      training_.acted(pending.group->sender, note.time);
    }
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
  allow();
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
  setup_.utilization.load(shadow());
  training_.set_back(is_reset ? -1 : time);
  if (OutputCopy& outputs = operator_.outputs(); outputs.is_here()) outputs.ask();  // it may be of the former state
  chart_.set_back(time);
  forget_findings(is_reset ? -1 : time);
  alarm_sources_.set_back(is_reset ? -1 : time, time);
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
    allow();
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
    group.body = explain(pending.name, time, group.sender.role);
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
  if (!group.error.empty()) return;
  log(time, 0, "hand", fmt::format("\"{}\":{}", key, trace::json_string(pending.name)), false, group.sender.name);
}

/// The answer to `why`: the shadow has the state.
std::string Desk::explain(const std::string& name, tables::Time time, Role role) {
  const scenario::RunView view(setup_.names, setup_.history, time, &shadow(),
                               {.links = link_states_ ? link_states_() : std::vector<exec::LinkState>(),
                                .carried = setup_.carried,
                                .scenario = playing_,
                                .frozen_at_panel = operator_.frozen(),
                                .shows_malfunctions = sees_all(role),
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
