// The trainees of a run.
#include "symplant/panel/training/trainees.hpp"

#include <algorithm>

namespace symplant::panel {

void Times::add(tables::Time time) {
  times_.push_back(time);
  if (times_.size() <= kMost) return;
  times_.pop_front();
  ++before_;
}

void Times::forget_after(tables::Time time) {
  while (!times_.empty() && times_.back() > time) times_.pop_back();
}

std::optional<tables::Time> Times::last() const { return times_.empty() ? std::nullopt : std::optional(times_.back()); }

std::optional<std::uint32_t> Trainees::find(std::string_view name) const {
  const auto found = std::find_if(all_.begin(), all_.end(), [&](const Trainee& each) { return each.name == name; });
  return found == all_.end() ? std::nullopt : std::optional(static_cast<std::uint32_t>(found - all_.begin()));
}

std::optional<std::uint32_t> Trainees::find_or_add(std::string_view name, tables::Time now) {
  if (const std::optional<std::uint32_t> found = find(name)) return found;
  if (all_.size() == kMost) return std::nullopt;
  ++version_;
  all_.push_back({std::string(name), now, {}, {}});
  return static_cast<std::uint32_t>(all_.size() - 1);
}

void Trainees::acted(std::uint32_t trainee, tables::Time time) {
  ++version_;
  all_[trainee].acts.add(time);
}

void Trainees::refused(std::uint32_t trainee, tables::Time time) {
  ++version_;
  all_[trainee].refusals.add(time);
}

void Trainees::set_back(tables::Time after) {
  ++version_;
  for (Trainee& trainee : all_) {
    trainee.since = std::min(trainee.since, std::max<tables::Time>(after, 0));
    trainee.acts.forget_after(after);
    trainee.refusals.forget_after(after);
  }
}

}  // namespace symplant::panel
