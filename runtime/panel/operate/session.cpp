// What was done in a session.
#include "symplant/panel/operate/session.hpp"

#include <algorithm>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/tables/duration.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::panel {
namespace {

constexpr std::size_t kMostDeeds = 10'000;
constexpr std::size_t kMostDeedBytes = std::size_t{16} << 20;

std::size_t bytes_of(const Deed& deed) {
  return deed.by.size() + deed.json.size() + deed.actions.size() + deed.name.size();
}

}  // namespace

void Session::add(Deed deed) {
  if (deed.by == role_name(Role::trainee)) deed.shown = shown_++;
  const std::size_t bytes = bytes_of(deed);
  if (!deed.actions.empty()) {
    is_complete_ = is_complete_ && steps_.size() < kMostSteps && step_bytes_ + bytes <= kMostStepBytes;
    if (is_complete_) {
      step_bytes_ += bytes;
      steps_.push_back(deed);
    }
  }
  deed_bytes_ += bytes;
  deeds_.push_back(std::move(deed));
  while (deeds_.size() > kMostDeeds || (deed_bytes_ > kMostDeedBytes && deeds_.size() > 1)) {
    deed_bytes_ -= bytes_of(deeds_.front());
    deeds_.pop_front();
    ++first_;
  }
}

void Session::begin_again(std::shared_ptr<const KeptState> from) {
  steps_.clear();
  step_bytes_ = 0;
  is_complete_ = true;
  from_ = std::move(from);
}

std::string Session::scenario(std::string_view restore, tables::Time end) const {
  std::string text = fmt::format("// A session at the panel of symplant {}, plant {}.", tables::version(),
                                 trace::json_string(names_.tables().name));
  if (seed_ != 0) text += fmt::format(" Run it with --seed {}.", seed_);
  text += "\n{\n  \"symplant-scenario\": 1,\n  \"steps\": [\n";
  if (from_ != nullptr) text += fmt::format("    {{ \"restore\": {} }},\n", trace::json_string(restore));
  const Deed* before = nullptr;
  for (const Deed& step : steps_) {
    const bool same_time = before != nullptr && before->time == step.time;
    if (same_time ? before->turn != step.turn : step.further) {
      text += fmt::format("    {{ \"at\": \"{}\", \"instant\": true }},\n", tables::duration_text(step.time));
    }
    text += fmt::format("    {{ \"at\": \"{}\", {} }},\n", tables::duration_text(step.time), step.actions);
    before = &step;
  }
  return text + fmt::format("    {{ \"at\": \"{}\" }}\n  ]\n}}\n", tables::duration_text(end));
}

void Session::put(std::string& json, std::uint64_t from, Role role) const {
  json += '[';
  for (std::uint64_t n = std::max(from, first_); n < count(); ++n) {
    const Deed& deed = deeds_[n - first_];
    if (!sees_all(role) && deed.by != role_name(Role::trainee)) continue;
    put_comma(json);
    panel::put(json, R"({{"n":{},"t":{},"by":"{}")", sees_all(role) ? n : deed.shown, deed.time, deed.by);
    if (!deed.name.empty() && sees_all(role)) put_member(json, "name", deed.name);
    panel::put(json, ",\"act\":{}}}", deed.json);
  }
  json += ']';
}

}  // namespace symplant::panel
