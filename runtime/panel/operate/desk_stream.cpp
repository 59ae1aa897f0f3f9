// The state of a panel: what the clients of its stream get.
#include <algorithm>

#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/picture/json_text.hpp"

namespace symplant::panel {
namespace {

constexpr std::size_t kMostShownActs = 200;  ///< of a picture

}  // namespace

void Desk::put_clock(std::string& json) const {
  const char* const state = ended_ ? "ended" : operator_.frozen() ? "frozen" : "running";
  const double speed = this->speed();
  put(json, R"({{"state":"{}","speed":{},"real_speed":{:.3g}}})", state,
      speed == 0 ? "\"max\"" : fmt::format("{}", speed), real_speed_);
}

void Desk::put_findings(std::string& json, std::uint64_t from, Role role) const {
  json += '[';
  for (std::uint64_t n = std::max(from, first_finding_); n < first_finding_ + findings_.size(); ++n) {
    const Found& found = findings_[n - first_finding_];
    const std::string& members = sees_all(role) ? found.json : found.shown;
    if (members.empty()) continue;
    put_comma(json);
    put(json, "{{\"n\":{},{}}}", sees_all(role) ? n : found.shown_number, members);
  }
  json += ']';
}

void Desk::put_requirements(std::string& json, bool all) const {
  json += '[';
  for (std::size_t r = 0; r < violations_.size(); ++r) {
    const Violation& violation = violations_[r];
    if (!all && !violation.changed) continue;
    put_comma(json);
    json += '[';
    if (!all) put(json, "{},", r);
    put(json, R"("{}",{},{}])", violation.count == 0 ? "ok" : "violated", violation.since, violation.count);
  }
  json += ']';
}

void Desk::put_description(std::string& json, Role role) const {
  put_member(json, "plant", setup_.names.tables().name);
  put(json, R"(,"model_hash":"{:016x}","mode":"live","acts":{},"with_plc":{},"speed":{},"files":{})",
      setup_.plant.model_hash(), setup_.acts, setup_.with_plc, setup_.paced, snapshots_.has_folder());
  put_exercises(json, sees_all(role) ? setup_.exercises : std::vector<ExerciseFile>());
}

/// The copy of the outputs of values, if it is here, and asks for the next one.
void Desk::take_outputs() {
  OutputCopy& outputs = operator_.outputs();
  if (outputs.empty() || !outputs.is_here()) return;
  picture_.take_outputs(outputs.numbers());
  outputs.ask();
}

std::string Desk::picture(Role role) {
  const tables::Time now = operator_.now();
  std::string json = beat();
  put_key(json, "clock");
  put_clock(json);
  picture_.put_all(json, now, role);
  put_key(json, "findings");
  put_findings(json, 0, role);
  put_key(json, "requirements");
  put_requirements(json, true);
  alarm_sources_.settle(now);
  put_key(json, "alarms");
  alarms_.put_all(json);
  put_key(json, "acts");
  session_.put(json, session_.count() > kMostShownActs ? session_.count() - kMostShownActs : 0, role);
  put_key(json, "snapshots");
  sees_all(role) ? snapshots_.put_all(json) : void(json += "[]");
  put_key(json, "messages");
  messages_.put(json, 0);
  if (sees_all(role)) {
    put_key(json, "training");
    training_.put(json, Training::kMostShown);
  }
  put_key(json, "scenario");
  played_.put(json, role);
  put_key(json, "exercise");
  if (exercise_ != nullptr) {
    exercise_->put(json, role);
  } else {
    json += "null";
  }
  put_key(json, "allowed");
  allowed_.put(json);
  put(json, ",\"layout\":{}", setup_.scene.revision());
  put_key(json, "camera");
  setup_.scene.put_camera(json);
  return json + "}";
}

void Desk::look_at_changes() {
  take_outputs();
  alarm_sources_.settle(operator_.now());
}

std::string Desk::changes(Role role) {
  std::string json;
  if (std::string clock; put_clock(clock), clock != sent_clock_) {
    put_key(json, "clock");
    json += clock;
  }
  if (picture_.has_changes()) picture_.put_changes(json, operator_.now(), role);
  // A list without a new item that the role sees is not sent: it would say that there is one that it does not see.
  const auto put_new = [&](std::string_view key, const std::string& items) {
    if (items == "[]") return;
    put_key(json, key);
    json += items;
  };
  std::string items;
  if (first_finding_ + findings_.size() != sent_findings_) put_findings(items, sent_findings_, role);
  if (!items.empty()) put_new("findings", items);
  if (std::any_of(violations_.begin(), violations_.end(), [](const Violation& v) { return v.changed; })) {
    put_key(json, "requirements");
    put_requirements(json, false);
  }
  if (alarms_.has_changes()) {
    put_key(json, "alarms");
    alarms_.put_changes(json);
  }
  items.clear();
  if (session_.count() != sent_acts_) session_.put(items, sent_acts_, role);
  if (!items.empty()) put_new("acts", items);
  if (snapshots_.version() != sent_snapshots_ && sees_all(role)) {
    put_key(json, "snapshots");
    snapshots_.put_all(json);
  }
  if (messages_.count() != sent_messages_) {
    put_key(json, "messages");
    messages_.put(json, sent_messages_);
  }
  if (training_.version() != sent_training_ && sees_all(role)) {
    put_key(json, "training");
    training_.put(json, Training::kMostShown);
  }
  if (played_.version() != sent_played_) {
    put_key(json, "scenario");
    played_.put(json, role);
  }
  if (exercise_ != nullptr && (exercise_.get() != sent_of_ || exercise_->version() != sent_exercise_)) {
    put_key(json, "exercise");
    exercise_->put(json, role);
  }
  if (allowed_.version() != sent_allowed_) {
    put_key(json, "allowed");
    allowed_.put(json);
  }
  if (setup_.scene.revision() != sent_layout_) {
    put_key(json, "layout");
    put(json, "{}", setup_.scene.revision());
  }
  if (setup_.scene.camera_switches() != sent_camera_) {
    put_key(json, "camera");
    setup_.scene.put_camera(json);
  }
  if (json.empty()) return json;
  return beat() + "," + json + "}";
}

void Desk::forget_changes() {
  sent_clock_.clear();
  put_clock(sent_clock_);
  picture_.forget_changes();
  sent_findings_ = first_finding_ + findings_.size();
  for (Violation& violation : violations_) violation.changed = false;
  alarms_.forget_changes();
  sent_acts_ = session_.count();
  sent_snapshots_ = snapshots_.version();
  sent_played_ = played_.version();
  sent_of_ = exercise_.get();
  sent_exercise_ = exercise_ != nullptr ? exercise_->version() : 0;
  sent_allowed_ = allowed_.version();
  sent_messages_ = messages_.count();
  sent_training_ = training_.version();
  sent_layout_ = setup_.scene.revision();
  sent_camera_ = setup_.scene.camera_switches();
}

std::string Desk::beat() const {
  return fmt::format("{{\"rev\":{},\"t\":{},\"now\":{}", revision_, operator_.now(), act_clock());
}

}  // namespace symplant::panel
