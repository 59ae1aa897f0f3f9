// Events that the PLC refuses to take.
#include "symplant/link/client/write_retries.hpp"

#include <algorithm>

#include "symplant/link/image/words.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::client {

std::vector<LaneChange> WriteRetries::add(std::span<const Unwritten> lanes, tables::Time now) {
  std::vector<LaneChange> added;
  for (std::size_t i = 0; i < events_.size(); ++i) {
    const bool meets_one = std::any_of(lanes.begin(), lanes.end(), [&](const Unwritten& one) {
      return std::any_of(events_[i].lanes.begin(), events_[i].lanes.end(),
                         [&](const LaneChange& lane) { return meet(lane, one.change); });
    });
    if (!meets_one) continue;
    const auto [at, is_new] = refused_.try_emplace(i);
    if (is_new) at->second.refuse(now, Answer::refused);
    added.insert(added.end(), events_[i].lanes.begin(), events_[i].lanes.end());
  }
  return added;
}

std::vector<std::size_t> WriteRetries::due(tables::Time now, std::size_t most) const {
  std::vector<std::size_t> events;
  for (const auto& [event, retry] : refused_) {
    if (events.size() == most) break;
    if (retry.is_due(now)) events.push_back(event);
  }
  return events;
}

std::vector<LaneChange> WriteRetries::changes(std::size_t event, const Events& events) const {
  std::vector<LaneChange> changes = events_[event].lanes;
  for (LaneChange& change : changes) {
    change.value = image::get_lane(events.of(change.lane.plane), change.lane.number);
  }
  return changes;
}

bool WriteRetries::refuse(std::size_t event, tables::Time now, Answer answer) {
  Retry& retry = refused_[event];
  retry.refuse(now, answer);
  return answer == Answer::refused && retry.refusals() == Retry::kLasting;
}

}  // namespace symplant::link::client
