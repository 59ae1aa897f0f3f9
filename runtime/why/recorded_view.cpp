// The state of a plant from the records of its run, completed by the plant.
#include "symplant/why/recorded_view.hpp"

#include <algorithm>

#include "symplant/trace/finding_words.hpp"

namespace symplant::why {

bool RecordedView::is_exact(std::uint32_t unit) const {
  return plant_ != nullptr && trace::pack_unit(plant_->unit(unit)) == trace::pack_unit(history_.unit(unit));
}

std::vector<PartState> RecordedView::parts(std::uint32_t location) const {
  std::vector<PartState> parts;
  for (const trace::History::Part& part : history_.parts_at(location)) {
    parts.push_back({part.number, part.kind, part.since, {}});
  }
  if (plant_ == nullptr || plant_->parts(location) != parts.size()) return parts;
  const bool on_track = plant_->tables().material.is_track(location);
  std::vector<PartState> located;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const plant::PartView view = plant_->part(location, i);
    const auto same = std::find_if(parts.begin(), parts.end(), [&](const PartState& part) {
      return part.number == view.number && part.kind == view.kind;
    });
    if (same == parts.end()) return parts;
    located.push_back(
        {view.number, view.kind, same->since, on_track ? std::optional(view.x) : std::nullopt, view.speed, view.drive});
  }
  return located;
}

std::optional<double> RecordedView::output(std::uint32_t output) const {
  if (plant_ != nullptr) return plant_->output(output);
  return history_.shows(output) ? std::optional(history_.output(output)) : std::nullopt;
}

std::optional<double> RecordedView::weight(std::uint32_t location) const {
  return plant_ != nullptr ? std::optional(plant_->weight(location)) : std::nullopt;
}

std::optional<tables::Time> RecordedView::remaining(std::uint32_t unit) const {
  return is_exact(unit) ? std::optional(plant_->unit(unit).remaining) : std::nullopt;
}

std::optional<tables::Time> RecordedView::after_left(std::uint32_t unit, std::uint16_t transition) const {
  return is_exact(unit) ? std::optional(plant_->after_left(unit, transition)) : std::nullopt;
}

std::optional<bool> RecordedView::is_armed(std::uint32_t operation) const {
  if (plant_ == nullptr) return {};
  const std::uint32_t bit = plant_->tables().symbols[operation].index;
  return (plant_->disarmed()[bit / 64] >> (bit % 64) & 1) == 0;
}

std::optional<bool> RecordedView::is_pending(std::uint32_t requirement) const {
  return plant_ != nullptr ? std::optional(plant_->is_pending(requirement)) : std::nullopt;
}

std::optional<bool> RecordedView::is_frozen_track(std::uint32_t track) const {
  return plant_ != nullptr ? std::optional(plant_->is_frozen_track(track)) : std::nullopt;
}

std::optional<plant::TransferView> RecordedView::transfer(std::uint32_t transfer) const {
  return plant_ != nullptr ? std::optional(plant_->transfer(transfer)) : std::nullopt;
}

std::optional<plant::SourceView> RecordedView::source(std::uint32_t source) const {
  return plant_ != nullptr ? std::optional(plant_->source(source)) : std::nullopt;
}

std::string RecordedView::forced(std::uint32_t symbol) const {
  const tables::Time since = history_.forced_since(symbol);
  return since < 0 ? std::string() : "since " + trace::seconds(since);
}

}  // namespace symplant::why
