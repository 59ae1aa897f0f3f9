// When an instant happens because of parts, and what is true at its end (docs/material.md, "When an instant happens").
#include <algorithm>

#include "support/reference/material.hpp"

namespace symplant::reference {
namespace {

/// The times of one part. All positions are those of its front.
struct PartTimes {
  const PartWorld& part;
  Time now;
  Time due = tables::kNever;

  void after(std::int64_t ns) { due = std::min(due, later(now, ns)); }
  /// When it is at a position or beyond it.
  void reaches(std::int64_t position) {
    const std::int64_t left = part.v > 0 ? position - part.x(now) : part.x(now) - position;
    const std::int64_t speed = std::abs(part.v);
    if (speed != 0 && left > 0) after((left + speed - 1) / speed);
  }
  /// When it is beyond a position.
  void passes(std::int64_t position) {
    const std::int64_t left = part.v > 0 ? position - part.x(now) : part.x(now) - position;
    const std::int64_t speed = std::abs(part.v);
    if (speed != 0 && left >= 0) after(left / speed + 1);
  }
  /// When it begins or ceases to cover a position.
  void covers(std::int64_t position, std::int64_t length) {
    reaches(part.v > 0 ? position : position + length);
    passes(part.v > 0 ? position + length : position);
  }
};

/// When a part that lies across leaves the sensors of the track that it came from.
void times_of_tail(const Rules& rules, const World& world, const TailWorld& tail, PartTimes& times) {
  const PartWorld& part = times.part;
  if (across(rules, world.material, tail, world.time) == nullptr) return;
  const model::Track& its = rules.model->material.tracks[tail.on];
  for (const model::PartSensor& sensor : its.sensors) {
    if (!sees(sensor, part)) continue;
    if (sensor.at == its.length) times.reaches(length_of(rules, part));
    if (sensor.at != its.length) times.passes(length_of(rules, part) - units_of(its.length - sensor.at));
  }
}

/// The next time at which a part reaches something on its track.
Time part_due(const Rules& rules, const World& world, std::uint32_t track, std::size_t index) {
  const model::Track& its = rules.model->material.tracks[track];
  const TrackWorld& there = world.material.tracks[track];
  const PartWorld& part = there.parts[index];
  const std::int64_t length = length_of(rules, part);
  PartTimes times{part, world.time};
  for (const model::PartSensor& sensor : its.sensors) {
    if (sees(sensor, part)) times.covers(units_of(sensor.at), length);
  }
  for (const TailWorld& tail : world.material.tails) {
    if (tail.number == part.number) times_of_tail(rules, world, tail, times);
  }
  for (const model::Transfer& transfer : rules.model->material.transfers) {
    if (transfer.from.location != track) continue;
    // Without a position it is the end, which a part covers only exactly there.
    if (transfer.from.at != tables::kWhole) times.covers(units_of(transfer.from.at), length);
    if (transfer.from.at == tables::kWhole && part.v < 0) times.passes(units_of(its.length));
  }
  for (std::size_t i = 0; i < its.stops.size(); ++i) {
    if (there.held[i]) times.reaches(units_of(its.stops[i].at) + (part.v < 0 ? length : 0));
  }
  times.reaches(part.v > 0 ? units_of(its.length) : length);
  for (std::size_t i = 0; i < there.facing.size(); ++i) {
    const std::int64_t boundary = units_of(its.drives[i].until) + length / 2;
    if (part.v > 0 || there.facing[i]) times.reaches(boundary);
    if (part.v < 0) times.passes(boundary);
  }
  if (index > 0 && part.v > there.parts[index - 1].v) {
    const std::int64_t left = contact_with(rules, there, its, index - 1, world.time) - part.x(world.time);
    const std::int64_t speed = part.v - there.parts[index - 1].v;
    if (left > 0) times.after((left + speed - 1) / speed);
  }
  return times.due;
}

/// When there is room, with the speeds as they are.
Time room_due(const Rules& rules, const World& world, const PartTarget& target) {
  const model::Material& material = rules.model->material;
  if (target.to.location == tables::kOut || !material.is_track(target.to.location)) return tables::kNever;
  const std::uint32_t location = target.to.location;
  const std::int64_t gap = units_of(material.tracks[location].gap);
  const std::int64_t front = front_at_target(rules, target);
  const std::int64_t back = front - units_of(material.kinds[target.kind].length);
  Time due = tables::kNever;
  for (const PartWorld& part : world.material.tracks[location].parts) {
    PartTimes times{part, world.time};
    times.reaches(part.v > 0 ? front + gap + length_of(rules, part) : back - gap);
    if (times.due < due && has_room(rules, world, target, times.due)) due = times.due;
  }
  for (const TailWorld& tail : world.material.tails) {
    const PartWorld* const part = across(rules, world.material, tail, world.time);
    if (tail.on != location || part == nullptr) continue;
    const std::int64_t length = length_of(rules, *part);
    PartTimes times{*part, world.time};
    times.reaches(std::min(length, front + gap - units_of(material.tracks[location].length) + length));
    if (times.due < due && has_room(rules, world, target, times.due)) due = times.due;
  }
  return due;
}

bool waits_for_room(const Rules& rules, const World& world, const PartTarget& target) {
  return !has_room(rules, world, target, world.time);
}

/// The part that a transfer moves as soon as there is room.
std::optional<PartTarget> waiting_for_transfer(const Rules& rules, const World& world, std::uint32_t index) {
  const model::Transfer& its = rules.model->material.transfers[index];
  const TransferWorld& there = world.material.transfers[index];
  if (there.frozen || (its.condition && !holds(*its.condition, world))) return {};
  if (its.once && !there.permission) return {};
  const auto part = part_to_take(rules, world, its.from);
  if (!part) return {};
  const PartWorld& it = world.material.at(its.from.location)[*part];
  return PartTarget{its.to, false, it.kind, it.number};
}

/// The next time at which a source is due, or at which a waiting part has room.
Time other_due(const Rules& rules, const World& world, Counters& counters) {
  Time due = order_due(rules, world);
  const auto wait = [&](const PartTarget& target, Counted counted) {
    if (!waits_for_room(rules, world, target)) return;
    ++counters[counted];
    if (has_room_between_parts(rules, world, target, world.time)) ++counters[Counted::tail_in_the_way];
    due = std::min(due, room_due(rules, world, target));
  };
  for (std::uint32_t i = 0; i < world.material.tracks.size(); ++i) {
    if (const auto target = leaving(rules, world, world, i)) wait(*target, Counted::end_waited);
  }
  for (std::uint32_t i = 0; i < world.material.transfers.size(); ++i) {
    if (const auto target = waiting_for_transfer(rules, world, i)) wait(*target, Counted::transfer_waited);
  }
  for (std::uint32_t i = 0; i < world.material.sources.size(); ++i) {
    const SourceWorld& source = world.material.sources[i];
    if (source.due > world.time) due = std::min(due, source.due);
    if (!source.frozen && due_and_allowed(rules, world, world, i)) {
      wait(next_of_source(rules, world, i), Counted::source_waited);
    }
  }
  return due;
}

void count_filtered(const Rules& rules, const World& world, Counters& counters) {
  const model::Material& material = rules.model->material;
  for (std::uint32_t i = 0; i < material.tracks.size(); ++i) {
    for (const model::PartSensor& sensor : material.tracks[i].sensors) {
      for (const PartWorld& part : world.material.tracks[i].parts) {
        const bool there = covers(rules, part, world.time, units_of(sensor.at));
        if (there && !sees(sensor, part)) ++counters[Counted::kind_filtered];
      }
    }
  }
}

}  // namespace

bool is_blocked(const Rules& rules, const World& world, std::uint32_t transfer) {
  const model::Transfer& its = rules.model->material.transfers[transfer];
  const TransferWorld& there = world.material.transfers[transfer];
  if (!its.condition || there.frozen || there.moved || !holds(*its.condition, world)) return false;
  const auto part = part_to_take(rules, world, its.from);
  if (!part) return false;
  const PartWorld& it = world.material.at(its.from.location)[*part];
  return !has_room(rules, world, {its.to, false, it.kind, it.number}, world.time);
}

void end_instant_of_parts(const Rules& rules, World& world, Counters& counters) {
  for (std::uint32_t i = 0; i < world.material.tracks.size(); ++i) {
    TrackWorld& track = world.material.tracks[i];
    track.own_due = tables::kNever;
    for (std::size_t j = 0; j < track.parts.size(); ++j) {
      track.own_due = std::min(track.own_due, part_due(rules, world, i, j));
    }
  }
  world.material.due = other_due(rules, world, counters);
  world.material.by_hand.clear();
  count_filtered(rules, world, counters);
}

Time next_due_of_parts(const MaterialWorld& world) {
  Time due = world.due;
  for (const TrackWorld& track : world.tracks) due = std::min(due, track.own_due);
  return due;
}

Steppers steppers(const Rules& rules) {
  const model::Material& material = rules.model->material;
  Steppers all{};
  all.tracks = rules.units.size() + rules.follows.size();
  all.transfers = all.tracks + material.tracks.size();
  all.work = all.transfers + material.transfers.size();
  all.sources = all.work + material.work.size();
  all.malfunctions = all.sources + material.sources.size();
  all.values = all.malfunctions + rules.model->malfunctions.size();
  all.end = all.values + rules.values.size();
  return all;
}

}  // namespace symplant::reference
