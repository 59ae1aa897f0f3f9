// Events that the PLC refuses to take, and when they are written again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/client/event_lanes.hpp"
#include "symplant/link/client/retry.hpp"

namespace symplant::link::client {

/// What is written together: one event with all its lanes, or the status. A refused request holds several of
/// them; each is written alone until the PLC takes it. A call costs one step for each event that is refused, and
/// refuse() one for each of the map.
class WriteRetries {
 public:
  explicit WriteRetries(std::vector<EventLanes> events) : events_(std::move(events)) {}

  /// No event is refused any more.
  void clear() noexcept { refused_.clear(); }
  /// Adds the events in these lanes; those that are there already are not changed. Returns the lanes of the events.
  std::vector<LaneChange> add(std::span<const Unwritten> lanes, tables::Time now);
  /// The events that are due, at most `most`: indexes for the other members.
  std::vector<std::size_t> due(tables::Time now, std::size_t most) const;
  /// The lanes of an event with its values.
  std::vector<LaneChange> changes(std::size_t event, const Events& events) const;
  void accept(std::size_t event) noexcept { refused_.erase(event); }
  /// The PLC has refused it again. True if with this refusal it counts as refused permanently.
  bool refuse(std::size_t event, tables::Time now, Answer answer);
  /// The symbol of an event; tables::kNone for the status.
  std::uint32_t symbol(std::size_t event) const { return events_[event].symbol; }

 private:
  std::vector<EventLanes> events_;
  std::map<std::size_t, Retry> refused_;  ///< by index in events_
};

}  // namespace symplant::link::client
