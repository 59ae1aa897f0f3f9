// How tracks, places and exits were used by parts.
#include "symplant/trace/utilization_parts.hpp"

#include <algorithm>

namespace symplant::trace {
namespace {

/// Whether something takes parts from a location, or works on them.
bool has_taker(const tables::MaterialTables& material, std::uint32_t location) {
  const auto is_from = [&](const tables::TransferRow& row) { return row.from.location == location; };
  const auto is_at = [&](const tables::WorkRow& row) { return row.at.location == location; };
  return (material.is_track(location) && material.tracks[location].ends.count != 0) ||
         std::any_of(material.transfers.begin(), material.transfers.end(), is_from) ||
         std::any_of(material.work.begin(), material.work.end(), is_at);
}

}  // namespace

PartUtilization::PartUtilization(const tables::MaterialTables& material, const History& history)
    : material_(material), history_(history), locations_(material.locations()) {
  for (std::uint32_t l = 0; l < locations_.size(); ++l) locations_[l].use.starves = has_taker(material, l);
  for (const tables::WorkRow& work : material.work) {
    if (material.is_track(work.at.location)) continue;
    std::vector<bool>& takes = locations_[work.at.location].work_takes;
    takes.resize(material.kinds.size());
    takes[work.from] = true;
  }
}

void PartUtilization::begin(tables::Time time) {
  location_of_.clear();
  exits_ = {};
  for (std::uint32_t l = 0; l < locations_.size(); ++l) {
    Location& location = locations_[l];
    location.at = time;
    location.use = {{}, location.use.starves, 0, 0, {}};
    for (const History::Part& part : history_.parts_at(l)) location_of_[part.number] = l;
    location.now = occupation(l);
  }
}

void PartUtilization::load(const plant::Plant& plant) {
  for (std::uint32_t track = 0; track < material_.tracks.size(); ++track) {
    const bool any = plant.parts(track) != 0;
    const plant::PartMotion front = any ? plant.motion(track, 0) : plant::PartMotion{};
    locations_[track].at_end = any && front.x >= material_.tracks[track].length && front.v == 0;
  }
}

/// Its time until now is of what it was until now.
void PartUtilization::count(Location& location, tables::Time time) const {
  location.use.times[static_cast<std::size_t>(location.now)] += std::max<tables::Time>(time - location.at, 0);
  location.at = std::max(location.at, time);
}

Occupation PartUtilization::occupation(std::uint32_t location) const {
  const Location& of = locations_[location];
  const std::vector<History::Part>& parts = history_.parts_at(location);
  if (parts.empty()) return Occupation::empty;
  if (material_.is_track(location)) return of.at_end ? Occupation::blocked : Occupation::used;
  return of.work_takes.empty() || of.work_takes[parts.front().kind] ? Occupation::used : Occupation::blocked;
}

void PartUtilization::look_at(std::uint32_t location, tables::Time time) {
  count(locations_[location], time);
  locations_[location].now = occupation(location);
}

void PartUtilization::move(const PartRecord& part) {
  if (part.changed()) {
    const auto found = location_of_.find(part.number);
    if (found != location_of_.end()) look_at(found->second, part.time);
    return;
  }
  if (!part.made()) {
    Location& from = locations_[part.from];
    ++from.use.left;
    if (part.to == tables::kOut && !part.by_hand) {
      from.use.exits.add(part.time);
      exits_.add(part.time);
    }
    look_at(part.from, part.time);
    location_of_.erase(part.number);
  }
  if (part.to == tables::kOut) return;
  ++locations_[part.to].use.came;
  location_of_[part.number] = part.to;
  look_at(part.to, part.time);
}

void PartUtilization::apply(const Record& record) {
  switch (record.kind) {
    case Record::Kind::part:
      part_ = record;
      break;
    case Record::Kind::part_move:
      move(part_record(part_, record));
      break;
    case Record::Kind::track:
      track_ = record.of;
      if (record.value == 0) {
        locations_[track_].at_end = false;
        look_at(track_, record.time);
      }
      break;
    case Record::Kind::part_speed:
      if (track_ == tables::kNone) break;
      locations_[track_].at_end =
          static_cast<std::int64_t>(record.value) >= material_.tracks[track_].length && record.of == 0;
      look_at(track_, record.time);
      track_ = tables::kNone;  // the others are behind the first one
      break;
    default:
      break;
  }
}

LocationUse PartUtilization::location(std::uint32_t location, tables::Time now) const {
  Location copy = locations_[location];
  count(copy, now);
  return copy.use;
}

}  // namespace symplant::trace
