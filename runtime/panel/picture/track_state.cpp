// What moves and holds the parts of tracks.
#include "symplant/panel/picture/track_state.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/why/needs.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::panel {

TrackStates::TrackStates(const tables::PlantTables& tables, const trace::History& history)
    : tables_(tables), history_(history), tracks_(tables.material.tracks.size()) {
  if (tracks_.empty()) return;
  const why::Conditions conditions(tables);
  const auto network = [&](std::uint32_t condition) {
    return condition == tables::kNone ? why::Network() : conditions.network(condition);
  };
  for (const tables::StopRow& stop : tables.material.stops) stops_.push_back(network(stop.condition));
  for (const tables::DriveRow& drive : tables.material.drives) {
    drives_.push_back({network(drive.forward), network(drive.backward)});
  }
}

/// The speed of a drive that moves forward, um/s, as the engine computes it (docs/material.md).
std::int64_t TrackStates::speed(const tables::DriveRow& row) const {
  if (row.symbol == tables::kNone) return row.speed;
  const tables::DataType type = tables_.symbols[row.symbol].type();
  const std::uint64_t value = history_.value(row.symbol);
  const double number = trace::is_real(type)     ? std::bit_cast<double>(value)
                        : trace::is_signed(type) ? static_cast<double>(static_cast<std::int64_t>(value))
                                                 : static_cast<double>(value);
  constexpr auto kMost = static_cast<double>(tables::kMaxSpeed);
  const double given = number * static_cast<double>(row.speed);
  return std::isnan(given) ? 0 : static_cast<std::int64_t>(std::clamp(given, -kMost, kMost));
}

bool TrackStates::update(std::uint32_t track, tables::Time now) {
  const tables::TrackRow& row = tables_.material.tracks[track];
  const why::RecordedView view(history_, now, nullptr);
  const auto holds = [&](const why::Network& network) { return !network.empty() && why::holds(network, view); };
  Track state;
  for (std::uint32_t i = row.stops.first; i < row.stops.first + row.stops.count; ++i) {
    state.stops.push_back(holds(stops_[i]));
  }
  for (std::uint32_t i = row.drives.first; i < row.drives.first + row.drives.count; ++i) {
    const bool forward = holds(drives_[i].forward);
    const std::int64_t most = speed(tables_.material.drives[i]);
    state.drives.push_back(forward == holds(drives_[i].backward) ? 0 : forward ? most : -most);
  }
  if (state == tracks_[track]) return false;
  tracks_[track] = std::move(state);
  return true;
}

void TrackStates::put(std::string& json, std::uint32_t track) const {
  json += '[';
  for (const bool holds : tracks_[track].stops) {
    put_comma(json);
    json += holds ? "true" : "false";
  }
  json += "],[";
  for (const std::int64_t speed : tracks_[track].drives) {
    put_comma(json);
    panel::put(json, "{}", speed);
  }
  json += ']';
}

}  // namespace symplant::panel
