// Events that the PLC refuses to take.
#include "symplant/link/client/write_retries.hpp"

#include <algorithm>

#include "symplant/link/image/table_view.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::client {

namespace {

constexpr std::uint16_t kWholeLane = 0xFFFF;

std::vector<LaneChange> registers(std::uint32_t first, std::uint32_t count) {
  std::vector<LaneChange> lanes;
  for (std::uint32_t k = 0; k < count; ++k) lanes.push_back({{Table::input_register, first + k}, kWholeLane, 0});
  return lanes;
}

std::vector<LaneChange> lanes_of(const IoPoint& point) {
  if (point.table == Table::input_register) return registers(point.number, point.width);
  return {{{Table::discrete_input, point.number / kLaneBits},
           static_cast<std::uint16_t>(1U << (point.number % kLaneBits)),
           0}};
}

}  // namespace

WriteRetries::WriteRetries(const IoMap& map) {
  for (const IoPoint& point : map.points) {
    const bool event = point.table == Table::discrete_input || point.table == Table::input_register;
    if (event) events_.push_back({point.symbol, lanes_of(point)});
  }
  if (map.status_block) events_.push_back({tables::kNone, registers(*map.status_block, kStatusRegisters)});
}

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

std::vector<LaneChange> WriteRetries::changes(std::size_t event, const image::Tables& events) const {
  std::vector<LaneChange> changes = events_[event].lanes;
  for (LaneChange& change : changes) {
    const auto words =
        change.lane.table == Table::discrete_input ? events.discrete_inputs.words : events.input_registers.words;
    change.value = image::get_register(words, change.lane.number);
  }
  return changes;
}

bool WriteRetries::refuse(std::size_t event, tables::Time now, Answer answer) {
  Retry& retry = refused_[event];
  retry.refuse(now, answer);
  return answer == Answer::refused && retry.refusals() == Retry::kLasting;
}

}  // namespace symplant::link::client
