// The lanes of the events of a link.
#include "symplant/link/client/event_lanes.hpp"

#include "symplant/link/image/numbers.hpp"
#include "symplant/link/image/words.hpp"

namespace symplant::link::client {

namespace {

constexpr std::uint16_t kWholeLane = 0xFFFF;

/// The lanes of a number's lowest words.
void add_number(std::vector<LaneChange>& lanes, Plane plane, std::uint32_t position, std::uint32_t words) {
  for (std::uint32_t k = 0; k < words; ++k) {
    lanes.push_back({{plane, image::kLanesPerWord * position + k}, kWholeLane, 0});
  }
}

}  // namespace

std::vector<LaneChange> lanes_of(const tables::PlantTables& tables, const image::Point& point) {
  std::vector<LaneChange> lanes;
  if (has_bits(point.plane)) {
    const auto mask = static_cast<std::uint16_t>(1U << (point.position % kLaneBits));
    lanes.push_back({{point.plane, point.position / kLaneBits}, mask, 0});
  } else {
    add_number(lanes, point.plane, point.position, image::words_of(tables.symbols[point.symbol].type()));
  }
  return lanes;
}

std::vector<EventLanes> event_lanes(const tables::PlantTables& tables, const image::Map& map) {
  std::vector<EventLanes> events;
  for (const image::Point& point : map.points) {
    if (is_event(point.plane)) events.push_back({point.symbol, lanes_of(tables, point)});
  }
  if (!map.status) return events;
  EventLanes status{tables::kNone, {}};
  std::uint32_t position = *map.status;
  for (const StatusField& field : kStatusFields)
    add_number(status.lanes, Plane::event_numbers, position++, field.words);
  events.push_back(std::move(status));
  return events;
}

}  // namespace symplant::link::client
