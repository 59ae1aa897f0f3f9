// What moves and holds the parts of tracks.
#include "symplant/panel/picture/track_state.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
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
std::int64_t TrackStates::speed(const tables::DriveRow& row, std::span<const double> numbers) const {
  if (!row.varies()) return row.speed;
  double number = 0;
  if (row.symbol == tables::kNone) {
    number = numbers[row.output];
  } else {
    const tables::DataType type = tables_.symbols[row.symbol].type();
    const std::uint64_t value = history_.value(row.symbol);
    number = trace::is_real(type)     ? std::bit_cast<double>(value)
             : trace::is_signed(type) ? static_cast<double>(static_cast<std::int64_t>(value))
                                      : static_cast<double>(value);
  }
  constexpr auto kMost = static_cast<double>(tables::kMaxSpeed);
  const double given = number * static_cast<double>(row.speed);
  return std::isnan(given) ? 0 : static_cast<std::int64_t>(std::clamp(given, -kMost, kMost));
}

/// Malfunctions act one after the other, in the order of the description.
std::int64_t TrackStates::slowed(std::uint32_t track, std::int64_t speed) const {
  const tables::MalfunctionNumbers numbers(tables_);
  std::vector<std::uint32_t> active;
  for (const trace::History::Malfunction& one : history_.malfunctions()) {
    if (numbers.is_written(one.number)) active.push_back(one.number);
  }
  std::sort(active.begin(), active.end());
  for (const std::uint32_t number : active) {
    for (const tables::EffectRow& effect : tables_.malfunctions.effects_of(number)) {
      if (numbers.names_track(effect, track)) speed = tables::slowed_drive(effect, speed);
    }
  }
  return speed;
}

bool TrackStates::update(std::uint32_t track, tables::Time now, std::span<const double> numbers) {
  const tables::TrackRow& row = tables_.material.tracks[track];
  const why::RecordedView view(history_, now, nullptr);
  const auto holds = [&](const why::Network& network) { return !network.empty() && why::holds(network, view); };
  Track state;
  for (std::uint32_t i = row.stops.first; i < row.stops.first + row.stops.count; ++i) {
    state.stops.push_back(holds(stops_[i]));
  }
  for (std::uint32_t i = row.drives.first; i < row.drives.first + row.drives.count; ++i) {
    const tables::DriveRow& drive = tables_.material.drives[i];
    const bool forward = drive.always_forward() || holds(drives_[i].forward);
    const bool backward = holds(drives_[i].backward);
    const std::int64_t most = speed(drive, numbers);
    state.drives.push_back(forward == backward ? 0 : slowed(track, forward ? most : -most));
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
