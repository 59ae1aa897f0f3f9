// The state of a panel: what its clients ask for.
#include <algorithm>
#include <utility>

#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/scenario/step_text.hpp"
#include "symplant/tables/duration.hpp"
#include "symplant/trace/utilization_text.hpp"

namespace symplant::panel {
namespace {

using Kind = Act::Kind;

constexpr const char* kNoFolder = "this run has no folder for files; start it with `--panel-files DIR`";

constexpr const char* kTooMany = "too many acts wait for the plant; try again";

constexpr const char* kNoName = "only a trainee joins, with a name in the header `X-Symplant-Name`";

constexpr const char* kTooManyTrainees =
    "100 trainees have joined already; use one of their names, or start the program again";

bool is_step(const Act& act) { return act.kind == Kind::step; }

Order::Kind order_kind(Kind kind) {
  switch (kind) {
    case Kind::run:
      return Order::Kind::run;
    case Kind::freeze:
      return Order::Kind::freeze;
    case Kind::step_cycle:
      return Order::Kind::step_cycle;
    case Kind::step_change:
      return Order::Kind::step_change;
    case Kind::reset:
      return Order::Kind::reset;
    default:
      return Order::Kind::act;
  }
}

/// One name, or a list of them.
std::string names_json(const std::vector<std::string>& names) {
  if (names.size() == 1) return trace::json_string(names.front());
  std::string json = "[";
  for (const std::string& name : names) json.append(json.size() > 1 ? "," : "").append(trace::json_string(name));
  return json + "]";
}

/// The act as JSON members, for the log.
std::string members_of(const Act& act) {
  const auto named = [&](const char* key) { return fmt::format("\"{}\":{}", key, trace::json_string(act.name)); };
  switch (act.kind) {
    case Kind::step:
      return "";
    case Kind::run:
      return "\"run\":true";
    case Kind::freeze:
      return "\"freeze\":true";
    case Kind::step_cycle:
      return "\"step\":\"cycle\"";
    case Kind::step_change:
      return "\"step\":\"change\"";
    case Kind::speed:
      return act.speed == 0 ? "\"speed\":\"max\"" : fmt::format("\"speed\":{}", act.speed);
    case Kind::reset:
      return "\"reset\":true";
    case Kind::snapshot:
      return named("snapshot");
    case Kind::save:
      return named("save");
    case Kind::restore:
      return named("restore");
    case Kind::forget:
      return named("forget");
    case Kind::exercise:
      return named("exercise");
    case Kind::end_exercise:
      return "\"end\":\"exercise\"";
    case Kind::count_again:
      return "\"count\":\"utilization\"";
    case Kind::join:
      return "\"join\":true";
    case Kind::message:
      return named("message");
    case Kind::camera:
      return named("camera");
    case Kind::session:
      return named("session");
    case Kind::acknowledge:
      return act.alarms.empty() ? "\"acknowledge\":\"all\"" : "\"acknowledge\":" + names_json(act.alarms);
    case Kind::shelve:
      return fmt::format("\"shelve\":{},\"for\":\"{}\"", names_json(act.alarms),
                         tables::duration_text(act.shelved_for));
    case Kind::unshelve:
      return "\"unshelve\":" + names_json(act.alarms);
    case Kind::silence:
      break;
  }
  return "\"silence\":true";
}

}  // namespace

const ExerciseFile* Desk::exercise_file(std::string_view name) const {
  const auto found = std::find_if(setup_.exercises.begin(), setup_.exercises.end(),
                                  [&](const ExerciseFile& file) { return file.name == name; });
  return found == setup_.exercises.end() ? nullptr : &*found;
}

/// Why an act is not possible now; empty if it is.
std::string Desk::refusal(const Act& act) {
  const bool saves = act.kind == Kind::snapshot || act.kind == Kind::save || act.kind == Kind::restore;
  if (saves && setup_.programs != nullptr) return "the state of a PLC program cannot be saved; use `reset`";
  switch (act.kind) {
    case Kind::speed:
      if (setup_.paced) return "";
      return setup_.with_plc ? "with a PLC, plant time is real time: the speed cannot be changed"
                             : "in the real-time cycle the speed cannot be changed; leave out `--clock real`";
    case Kind::save:
    case Kind::session:
      return snapshots_.has_folder() ? "" : kNoFolder;
    case Kind::exercise:
      if (exercise_file(act.name) == nullptr) {
        return fmt::format("there is no exercise `{}`; give its file with `--exercise FILE`", act.name);
      }
      [[fallthrough]];
    case Kind::reset:
      return setup_.by_plc_clock ? "plant time follows the PLC's clock, and cannot be set back" : "";
    case Kind::restore: {
      if (setup_.by_plc_clock) return "plant time follows the PLC's clock, and cannot be set back";
      std::string error;
      snapshots_.find(act.name, setup_.plant.model_hash(), block_, error);
      return error;
    }
    case Kind::camera: {
      if (setup_.scene.has_camera(act.name)) return "";
      const std::string_view nearest = setup_.scene.nearest_camera(act.name);
      return fmt::format("`view3d` of plant.json has no camera `{}`{}", act.name,
                         nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
    }
    case Kind::acknowledge:
    case Kind::shelve:
    case Kind::unshelve:
      return alarm_refusal(act);
    default:
      return "";
  }
}

std::string Desk::alarm_refusal(const Act& act) const {
  for (const std::string& name : act.alarms) {
    const AlarmList::Entry* const entry = alarms_.find(name);
    if (entry == nullptr) {
      const std::string_view nearest = alarms_.nearest(name);
      return fmt::format("alarm `{}` is not in the list{}", name,
                         nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
    }
    if (act.kind == Kind::acknowledge && entry->shelved) {
      return fmt::format("alarm `{}` is shelved; `unshelve` it first", name);
    }
    if (act.kind == Kind::unshelve && !entry->shelved) return fmt::format("alarm `{}` is not shelved", name);
  }
  return "";
}

std::string Desk::refusal(const std::vector<Act>& acts) {
  for (const Act& act : acts) {
    if (std::string why = refusal(act); !why.empty()) return why;
  }
  return "";
}

std::optional<Answer> Desk::refused(const ReadActs& read, const Sender& sender) {
  if (!read.error.empty()) return error_answer(read.is_of_trainer ? 403 : read.is_form ? 400 : 422, read.error);
  if (!sees_all(sender.role)) {
    for (const Act& act : read.acts) {
      if (const std::string why = allowed_.refusal(act); !why.empty()) return error_answer(403, why);
    }
  }
  const std::string why = refusal(read.acts);
  return why.empty() ? std::nullopt : std::optional(error_answer(422, why));
}

/// Counts the answer if it refuses what a trainee asks for.
Answered Desk::counted(const Sender& sender, Answered answered) {
  if (!Training::is_listed(sender)) return answered;
  return [this, sender, answered = std::move(answered)](Answer answer) {
    training_.answered(sender, answer.status, operator_.now());
    answered(std::move(answer));
  };
}

Answer Desk::check(std::string_view body, const Sender& sender) {
  return refused(reader_.read(body, sender.role), sender).value_or(Answer{200, "{}"});
}

void Desk::request(std::string_view body, const Sender& sender, Answered answered) {
  answered = counted(sender, std::move(answered));
  ReadActs read = reader_.read(body, sender.role);
  if (auto refusal = refused(read, sender)) return answered(std::move(*refusal));
  if (ended_) return answered(error_answer(503, "the run has ended"));
  if (read.until < act_clock()) return answered(error_answer(422, kTooLateText));
  if (pending_.size() + 2 * read.acts.size() > Operator::kMostOrders) {
    return answered(error_answer(429, kTooMany));
  }
  const auto group = std::make_shared<Group>();
  group->answered = std::move(answered);
  group->time = operator_.now();
  group->until = read.until;
  group->sender = sender;
  ++group->waiting;  // until all orders are offered
  carry_out(std::move(read.acts), group);
  --group->waiting;
  finish(group);
}

/// Answers the request if all its orders are done.
void Desk::finish(const std::shared_ptr<Group>& group) {
  if (group->waiting != 0 || !group->answered) return;
  const Answered answered = std::exchange(group->answered, nullptr);
  if (!group->error.empty()) {
    answered(error_answer(ended_ ? 503 : 422, group->error));
  } else {
    answered({200, group->body.empty() ? fmt::format("{{\"t\":{}}}", group->time) : group->body});
  }
}

void Desk::carry_out(std::vector<Act> acts, const std::shared_ptr<Group>& group) {
  for (std::size_t i = 0; i < acts.size();) {
    if (!is_step(acts[i])) {
      order(acts[i++], group);
      continue;
    }
    Pending pending{};  // all steps in a row take effect in one instant
    pending.purpose = Purpose::act;
    pending.order.kind = Order::Kind::act;
    pending.order.until = group->until;
    pending.group = group;
    for (; i < acts.size() && is_step(acts[i]); ++i) pending.steps.push_back(std::move(acts[i].step));
    offer(std::move(pending));
  }
}

void Desk::order(const Act& act, const std::shared_ptr<Group>& group) {
  switch (act.kind) {
    case Kind::snapshot:
      return offer_copy(Purpose::snapshot, act.name, group);
    case Kind::save:
      return offer_copy(Purpose::save, act.name, group);
    case Kind::restore: {
      std::string error;
      auto state = snapshots_.find(act.name, setup_.plant.model_hash(), block_, error);
      if (state != nullptr) return offer_restore(std::move(state), act.name, group);
      group->error = std::move(error);
      return;
    }
    case Kind::exercise:
      return offer_exercise(act.name, group);
    case Kind::speed:
    case Kind::forget:
    case Kind::session:
    case Kind::count_again:
    case Kind::join:
    case Kind::message:
    case Kind::camera:
    case Kind::acknowledge:
    case Kind::shelve:
    case Kind::unshelve:
    case Kind::silence:
      return at_once(act, group);
    default:
      break;
  }
  if (act.kind == Kind::end_exercise) {
    asked_player_ = nullptr;
    play_ = 0;
  }
  Pending pending{};
  pending.purpose = act.kind == Kind::end_exercise ? Purpose::play : Purpose::control;
  pending.name = members_of(act);
  pending.order.kind = act.kind == Kind::end_exercise ? Order::Kind::play : order_kind(act.kind);
  if (act.kind != Kind::end_exercise) pending.order.until = group->until;
  pending.group = group;
  offer(std::move(pending));
}

/// What the thread of the plant has no part in.
void Desk::at_once(const Act& act, const std::shared_ptr<Group>& group) {
  if (act.kind == Kind::speed) speed_.store(act.speed, std::memory_order_relaxed);
  if (act.kind == Kind::forget && !snapshots_.forget(act.name)) {
    group->error = fmt::format("there is no snapshot `{}` in memory", act.name);
  }
  if (act.kind == Kind::session) group->error = save_session(act.name);
  if (act.kind == Kind::count_again) setup_.utilization.begin(operator_.now());
  if (act.kind == Kind::join && !Training::is_listed(group->sender)) {
    group->error = kNoName;
  } else if (act.kind == Kind::join && !training_.seen(group->sender, operator_.now())) {
    group->error = kTooManyTrainees;
  }
  if (act.kind == Kind::message) messages_.add(operator_.now(), act.name);
  if (act.kind == Kind::camera) setup_.scene.switch_camera(act.name);
  if (!group->error.empty()) return;
  const std::string members = members_of(act);
  const std::size_t waiting = alarms_.waiting();
  on_alarms(act, members);
  const bool is_reaction = act.kind == Kind::acknowledge && alarms_.waiting() < waiting;
  if (is_reaction) training_.acted(group->sender, operator_.now());
  log(operator_.now(), 0, name_of_hand(group->sender.role), members, false, group->sender.name);
}

/// Does nothing for other acts.
void Desk::on_alarms(const Act& act, const std::string& members) {
  const tables::Time now = operator_.now();
  switch (act.kind) {
    case Kind::acknowledge:
      if (act.alarms.empty()) alarms_.acknowledge_all(now);
      for (const std::string& name : act.alarms) alarms_.acknowledge(name, now);
      break;
    case Kind::shelve:
      for (const std::string& name : act.alarms) alarms_.shelve(name, now + act.shelved_for, now);
      break;
    case Kind::unshelve:
      for (const std::string& name : act.alarms) alarms_.unshelve(name);
      break;
    case Kind::silence:
      alarms_.silence();
      break;
    default:
      return;
  }
  new_alarm_acts_.push_back({now, "{" + members + "}"});
}

std::string Desk::utilization(Role role) const {
  return trace::utilization_table_json(setup_.utilization, operator_.now(), sees_all(role));
}

std::string Desk::utilization_of(std::uint32_t unit, Role role) const {
  return trace::device_use_json(setup_.utilization, unit, operator_.now(), sees_all(role));
}

std::string Desk::utilization_table(Role role) const {
  return trace::utilization_csv(setup_.utilization, operator_.now(), sees_all(role));
}

void Desk::offer(Pending pending) {
  const std::uint32_t id = next_id_;
  next_id_ = static_cast<std::uint32_t>((next_id_ + 1) % kLeastOutcome);
  pending.order.id = id;
  ++pending.group->waiting;
  Pending& kept = pending_.emplace(id, std::move(pending)).first->second;
  kept.order.steps = kept.steps;
  operator_.offer(kept.order);
}

void Desk::offer_copy(Purpose purpose, std::string name, const std::shared_ptr<Group>& group) {
  Pending pending{};
  pending.purpose = purpose;
  pending.name = std::move(name);
  pending.group = group;
  pending.order.kind = Order::Kind::copy;
  pending.state = std::make_shared<KeptState>();
  pending.state->snapshot.block.resize(block_);
  pending.state->snapshot.model_hash = setup_.plant.model_hash();
  pending.order.block = pending.state->snapshot.block;
  if (asked_player_ != nullptr && purpose != Purpose::why) {
    pending.state->play = play_;
    pending.state->played = asked_player_->make_state();
    pending.order.played = &*pending.state->played;
  }
  offer(std::move(pending));
}

void Desk::offer_restore(std::shared_ptr<KeptState> state, std::string name, const std::shared_ptr<Group>& group) {
  Pending pending{};
  pending.purpose = Purpose::restore;
  pending.name = std::move(name);
  pending.group = group;
  pending.order.kind = Order::Kind::restore;
  pending.order.block = state->snapshot.block;
  if (state->played && state->play == play_) pending.order.played = &*state->played;
  if (pending.order.played == nullptr) {
    asked_player_ = nullptr;
    play_ = 0;
  }
  pending.asked = operator_.now();
  pending.state = std::move(state);
  offer(std::move(pending));
}

void Desk::offer_exercise(const std::string& name, const std::shared_ptr<Group>& group) {
  const ExerciseFile& file = *exercise_file(name);
  if (file.scenario->restore.empty()) {
    Pending reset{};
    reset.purpose = Purpose::control;
    reset.order.kind = Order::Kind::reset;
    reset.name = "\"reset\":true";
    reset.group = group;
    offer(std::move(reset));
  } else {
    trace::ReadSnapshot read = trace::read_snapshot(file.scenario->restore, setup_.plant.model_hash(), block_);
    if (!read.error.empty()) {
      group->error = std::move(read.error);
      return;
    }
    offer_restore(std::make_shared<KeptState>(KeptState{std::move(read.snapshot)}), file.scenario->restore, group);
  }
  Pending play{};
  play.purpose = Purpose::play;
  play.name = fmt::format("\"exercise\":{}", trace::json_string(name));
  play.order.kind = Order::Kind::play;
  play.group = group;
  play.exercise = std::make_shared<Exercise>(file, setup_.names);
  play.player = std::make_unique<scenario::Player>(*file.scenario, setup_.plant, setup_.recorder);
  play.player->note_steps(true);
  play.order.player = play.player.get();
  asked_player_ = play.player.get();
  play_ = ++plays_;
  offer(std::move(play));
}

void Desk::why(std::string_view name, const Sender& sender, Answered answered) {
  if (why::things_named(name, setup_.names).empty()) {
    const std::string nearest = why::nearest_thing(name, setup_.names);
    return answered(error_answer(
        422, fmt::format("`{}` not found{}", name, nearest.empty() ? "" : "; did you mean `" + nearest + "`?")));
  }
  if (ended_) return answered(error_answer(503, "the run has ended"));
  if (pending_.size() >= Operator::kMostOrders) return answered(error_answer(429, kTooMany));
  const auto group = std::make_shared<Group>();
  group->answered = std::move(answered);
  group->sender = sender;
  offer_copy(Purpose::why, std::string(name), group);
}

}  // namespace symplant::panel
