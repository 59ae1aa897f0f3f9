// Where parts are, where there is room, and how they get from one location to another (docs/material.md).
#include <algorithm>

#include "support/reference/material.hpp"

namespace symplant::reference {

std::int64_t front_at_target(const Rules& rules, const PartTarget& target) {
  const model::Material& material = rules.model->material;
  const std::int64_t length = units_of(material.kinds[target.kind].length);
  if (target.by_end) return 0;
  if (target.to.at == tables::kWhole) return length;
  return std::min(units_of(target.to.at) + length / 2, units_of(material.tracks[target.to.location].length));
}

std::int64_t length_of(const Rules& rules, const PartWorld& part) {
  return units_of(rules.model->material.kinds[part.kind].length);
}

std::int64_t middle_of(const Rules& rules, const PartWorld& part, Time time) {
  return part.x(time) - length_of(rules, part) / 2;
}

bool covers(const Rules& rules, const PartWorld& part, Time time, std::int64_t position) {
  const std::int64_t x = part.x(time);
  return x - length_of(rules, part) <= position && position <= x;
}

bool sees(const model::PartSensor& sensor, const PartWorld& part) {
  return sensor.kinds.empty() || std::find(sensor.kinds.begin(), sensor.kinds.end(), part.kind) != sensor.kinds.end();
}

bool senses_parts(const model::PlantModel& model, std::uint32_t symbol) {
  const auto is_its = [&](const model::PartSensor& sensor) { return sensor.symbol == symbol; };
  const auto has = [&](const auto& location) {
    return std::any_of(location.sensors.begin(), location.sensors.end(), is_its);
  };
  const model::Material& material = model.material;
  return std::any_of(material.tracks.begin(), material.tracks.end(), has) ||
         std::any_of(material.places.begin(), material.places.end(), has);
}

MaterialWorld first_material(const Rules& rules) {
  const model::Material& material = rules.model->material;
  MaterialWorld world;
  for (const model::Track& track : material.tracks) {
    TrackWorld& its = world.tracks.emplace_back();
    its.held.resize(track.stops.size());
    its.facing.resize(track.drives.size() - 1);
  }
  world.places.resize(material.places.size());
  world.transfers.resize(material.transfers.size());
  world.work.resize(material.work.size());
  for (const model::Source& source : material.sources) {
    world.sources.emplace_back().due = source.count == 0U ? tables::kNever : source.first;
  }
  world.made.resize(material.kinds.size());
  world.gone.resize(material.kinds.size());
  return world;
}

std::uint64_t parts_at(const MaterialWorld& world, std::uint32_t location, std::uint32_t kind) {
  std::uint64_t count = 0;
  for (const PartWorld& part : world.at(location)) count += kind == kNone || part.kind == kind ? 1 : 0;
  return count;
}

bool has_room(const Rules& rules, const World& world, const PartTarget& target, Time time) {
  return has_room_between_parts(rules, world, target, time) && has_room_between_tails(rules, world, target, time);
}

// Part and interval are open: they may touch.
bool has_room_between_parts(const Rules& rules, const World& world, const PartTarget& target, Time time) {
  const model::Material& material = rules.model->material;
  const std::uint32_t location = target.to.location;
  if (location == tables::kOut) return true;
  if (!material.is_track(location)) {
    const std::size_t place = location - material.tracks.size();
    return world.material.places[place].size() < material.places[place].holds;
  }
  const std::int64_t gap = units_of(material.tracks[location].gap);
  const std::int64_t x = front_at_target(rules, target);
  const std::int64_t back = x - units_of(material.kinds[target.kind].length) - gap;
  const std::int64_t front = x + gap;
  for (const PartWorld& part : world.material.tracks[location].parts) {
    if (part.number == target.number) continue;
    if (part.x(time) > back && part.x(time) - length_of(rules, part) < front) return false;
  }
  return true;
}

std::optional<std::size_t> part_to_take(const Rules& rules, const World& world, const tables::PartLocation& from) {
  const model::Material& material = rules.model->material;
  const std::vector<PartWorld>& parts = world.material.at(from.location);
  if (parts.empty()) return {};
  if (!material.is_track(from.location)) return 0;
  if (from.at == tables::kWhole) {
    const bool at_end = parts[0].x(world.time) == units_of(material.tracks[from.location].length);
    return at_end ? std::optional<std::size_t>(0) : std::nullopt;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (covers(rules, parts[i], world.time, units_of(from.at))) return i;
  }
  return {};
}

void arrive(const Rules& rules, World& world, PartWorld part, const PartTarget& target,
            std::vector<engine::PartChange>& changes, engine::PartChange change) {
  const model::Material& material = rules.model->material;
  part.v = 0;
  part.rebase(0, world.time);
  change.number = part.number;
  change.kind = part.kind;
  change.to = target.to.location;
  change.x = 0;
  if (target.to.location == tables::kOut) {
    ++world.material.gone[part.kind];
  } else if (!material.is_track(target.to.location)) {
    world.material.at(target.to.location).push_back(part);
  } else {
    part.x0 = front_at_target(rules, target);
    change.x = part.x0 / kMicrometer;
    std::vector<PartWorld>& parts = world.material.at(target.to.location);
    const auto behind =
        std::find_if(parts.begin(), parts.end(), [&](const PartWorld& other) { return other.x(world.time) < part.x0; });
    parts.insert(behind, part);
  }
  changes.push_back(change);
}

void make_part(const Rules& rules, World& world, const tables::PartLocation& to, std::uint32_t kind, bool by_hand,
               std::vector<engine::PartChange>& changes) {
  PartWorld part;
  part.number = world.material.next_number++;
  part.kind = kind;
  ++world.material.made[kind];
  engine::PartChange change{};
  change.what = engine::PartChange::What::made;
  change.from = tables::kOut;
  change.by_hand = by_hand;
  arrive(rules, world, part, {to, false, kind, part.number}, changes, change);
}

void move_part(const Rules& rules, World& world, std::uint32_t from, std::size_t index, const PartTarget& target,
               bool by_hand, std::vector<engine::PartChange>& changes) {
  std::vector<PartWorld>& parts = world.material.at(from);
  const PartWorld part = parts[index];
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(index));
  engine::PartChange change{};
  change.what = engine::PartChange::What::moved;
  change.from = from;
  change.by_hand = by_hand;
  std::erase_if(world.material.tails, [&](const TailWorld& tail) { return tail.number == part.number; });
  arrive(rules, world, part, target, changes, change);
  if (!target.by_end || target.to.location == tables::kOut) return;
  if (!rules.model->material.is_track(target.to.location)) return;
  world.material.tails.push_back({part.number, from, target.to.location, world.time});
}

}  // namespace symplant::reference
