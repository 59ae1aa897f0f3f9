// The lanes of the events of a link, which are written together.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/image/map.hpp"

namespace symplant::link::client {

/// One event with all its lanes, or the status.
struct EventLanes {
  std::uint32_t symbol;           ///< tables::kNone for the status
  std::vector<LaneChange> lanes;  ///< ascending, without values
};

/// The bits of a point's lanes, without values. O(1).
std::vector<LaneChange> lanes_of(const tables::PlantTables& tables, const image::Point& point);

/// The events in the order of the map, then the status if it has one. O(points).
std::vector<EventLanes> event_lanes(const tables::PlantTables& tables, const image::Map& map);

}  // namespace symplant::link::client
