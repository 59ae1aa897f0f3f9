// Why a part on a track does not move.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/why/walk.hpp"

namespace symplant::why {
namespace {

/// The speed that a number gives, in um/s, as the engine computes it. Only its sign matters here.
double speed_of(tables::DataType type, std::uint64_t value, std::int64_t unit) {
  const double number = trace::is_real(type)     ? std::bit_cast<double>(value)
                        : trace::is_signed(type) ? static_cast<double>(static_cast<std::int64_t>(value))
                                                 : static_cast<double>(value);
  const double speed = std::trunc(number * static_cast<double>(unit));
  return std::isnan(speed) ? 0 : speed;
}

}  // namespace

/// The direction in which a drive moves parts: -1, 0 or 1.
int Walk::direction_of_drive(std::uint32_t drive) const {
  const tables::DriveRow& row = tables_.material.drives[drive];
  const auto on = [&](std::uint32_t condition) {
    return condition != tables::kNone && holds(index_.conditions.network(condition), view_);
  };
  const bool forward = on(row.forward);
  if (forward == on(row.backward)) return 0;
  double speed = 1;
  if (row.symbol != tables::kNone) {
    speed = speed_of(tables_.symbols[row.symbol].type(), view_.value(row.symbol), row.speed);
  }
  const int direction = speed > 0 ? 1 : speed < 0 ? -1 : 0;
  return forward ? direction : -direction;
}

Explanation Walk::part(const Place& place) {
  const PartState& part = place.parts[place.index];
  const Reference self{Reference::Kind::part, static_cast<std::uint32_t>(part.number)};
  const std::string name = fmt::format("part {} ({})", part.number, names_.part_kind(part.kind));
  Explanation result{{}, {self, {Reference::Kind::location, place.track}}, {}};
  if (!part.x) {
    result.sentence =
        fmt::format("{} has been on {} {}", name, names_.location(place.track), trace::since_words(part.since));
    return result;
  }
  result.sentence =
      fmt::format("{} on {}, with its front at {}, ", name, names_.location(place.track), millimeters(*part.x));
  if (part.speed != 0) {
    result.sentence +=
        fmt::format("moves {}at {}/s", part.speed < 0 ? "backward " : "", millimeters(std::abs(part.speed)));
    return result;
  }
  result.sentence += "does not move";
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  add_halt(place, result);
  append(result.because, causes(takers_of(place), [this](const Reference& taker) { return transfer(taker.index); }));
  return result;
}

/// What stops a part.
void Walk::add_halt(const Place& place, Explanation& result) {
  const tables::MaterialTables& material = tables_.material;
  const tables::TrackRow& track = material.tracks[place.track];
  const PartState& part = place.parts[place.index];
  const std::int64_t length = material.kinds[part.kind].length;
  if (view_.is_frozen_track(place.track).value_or(false)) {
    result.sentence += ": the track is in an instantaneous loop, and stays frozen until the run ends";
    return;
  }
  const std::uint32_t drive = track.drives.first + part.drive;
  const int direction = direction_of_drive(drive);
  if (direction == 0) {
    add_drive(drive, result);
    return;
  }
  if (direction < 0 && part.drive > 0 && direction_of_drive(drive - 1) > 0) {
    const std::int64_t middle = 2 * *part.x - length;  // twice as much, rounded down
    const std::int64_t boundary = 2 * material.drives[drive - 1].until;
    if (middle <= boundary && boundary < middle + 2) {
      result.sentence += ": two drives push it against each other";
      return;
    }
  }
  const std::int64_t edge = direction > 0 ? *part.x : *part.x - length;
  for (const tables::StopRow& stop : material.stops.subspan(track.stops.first, track.stops.count)) {
    const Network condition = index_.conditions.network(stop.condition);
    if (stop.at != edge || !holds(condition, view_)) continue;
    result.sentence += fmt::format(": the stop at {} holds", millimeters(stop.at));
    append(result.because, causes_of(changes_of(condition, view_)));
    return;
  }
  const bool ends = direction > 0 ? edge >= track.length : edge <= 0;
  if (ends && direction > 0) return add_end(place, result);
  if (ends) {
    result.sentence += ": it is at the start of the track";
    return;
  }
  const std::size_t other = direction > 0 ? place.index - 1 : place.index + 1;
  if (other >= place.parts.size()) return;  // none is there
  result.sentence += fmt::format(": part {} is in front of it", place.parts[other].number);
  append(result.because, causes(std::vector{other}, [&](std::size_t i) {
           return this->part({place.track, i, place.parts});
         }));
}

/// Why a drive does not move.
void Walk::add_drive(std::uint32_t drive, Explanation& result) {
  const tables::DriveRow& row = tables_.material.drives[drive];
  const auto network = [this](std::uint32_t condition) { return index_.conditions.network(condition); };
  const bool forward = row.forward != tables::kNone && holds(network(row.forward), view_);
  const bool backward = row.backward != tables::kNone && holds(network(row.backward), view_);
  if (forward && backward) {
    result.sentence += ": its drive is commanded forward and backward";
    append(result.because, causes_of(changes_of(network(row.forward), view_)));
    append(result.because, causes_of(changes_of(network(row.backward), view_)));
  } else if (forward || backward) {
    result.sentence += ": the speed of its drive is 0";
    append(result.because, causes(std::vector{row.symbol}, [this](std::uint32_t of) { return symbol(of); }));
  } else {
    result.sentence += ": its drive is off";
    if (row.forward != tables::kNone) add_need(result, ", `forward`", network(row.forward));
    if (row.backward != tables::kNone) add_need(result, ", `backward`", network(row.backward));
  }
}

/// Why a part at the end of a track stays there.
void Walk::add_end(const Place& place, Explanation& result) {
  const tables::TrackRow& track = tables_.material.tracks[place.track];
  result.sentence += ": the track ends there";
  for (const tables::EndRow& end : tables_.material.ends.subspan(track.ends.first, track.ends.count)) {
    const std::string to(names_.location(end.to));
    if (end.condition != tables::kNone &&
        add_need(result, fmt::format(", to {} `when`", to), index_.conditions.network(end.condition))) {
      continue;
    }
    if (end.to == tables::kOut) return;
    result.sentence += fmt::format(", {} has no room", to);
    append(result.because, causes(std::vector{end.to}, [this](std::uint32_t of) { return location(of); }));
    return;
  }
}

}  // namespace symplant::why
