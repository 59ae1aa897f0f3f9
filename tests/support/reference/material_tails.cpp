// Parts that lie across two tracks, in the reference (docs/material.md, "The end").
#include <algorithm>

#include "support/reference/material.hpp"

namespace symplant::reference {
namespace {

/// Whether one of two tails on a track is read before the other.
bool is_before(const TailWorld& a, const PartWorld& a_part, const TailWorld& b, const PartWorld& b_part, Time time) {
  if (a_part.x(time) != b_part.x(time)) return a_part.x(time) > b_part.x(time);
  return a.left < b.left;
}

/// Calls `function(ahead, its part, other, its part)` for each two tails on one track, the first one read before.
template <class Function>
void for_pairs(const Rules& rules, const World& world, Time time, Function function) {
  for (const TailWorld& a : world.material.tails) {
    for (const TailWorld& b : world.material.tails) {
      if (a.number == b.number || a.on != b.on) continue;
      const PartWorld* const a_part = across(rules, world.material, a, time);
      const PartWorld* const b_part = across(rules, world.material, b, time);
      if (a_part == nullptr || b_part == nullptr || !is_before(a, *a_part, b, *b_part, time)) continue;
      function(a, *a_part, b, *b_part);
    }
  }
}

void count_tails(const Rules& rules, const World& world, Counters& counters) {
  const Time before = world.last_instant;
  for (const TailWorld& tail : world.material.tails) {
    const PartWorld* const part = across(rules, world.material, tail, before);
    if (part == nullptr) continue;
    for (const model::PartSensor& sensor : rules.model->material.tracks[tail.on].sensors) {
      const std::int64_t at = units_of(sensor.at);
      if (!sees(sensor, *part) || begin_of_tail(rules, tail, *part, before) > at) continue;
      const bool there = across(rules, world.material, tail, world.time) != nullptr &&
                         begin_of_tail(rules, tail, *part, world.time) <= at;
      if (!there) ++counters[Counted::tail_left_a_sensor];
    }
  }
  for_pairs(rules, world, before,
            [&](const TailWorld& a, const PartWorld& a_part, const TailWorld& b, const PartWorld& b_part) {
              if (is_before(b, b_part, a, a_part, world.time)) ++counters[Counted::tail_got_further];
            });
}

}  // namespace

const PartWorld* across(const Rules& rules, const MaterialWorld& world, const TailWorld& tail, Time time) {
  for (const PartWorld& part : world.tracks[tail.to].parts) {
    if (part.number == tail.number && part.x(time) < length_of(rules, part)) return &part;
  }
  return nullptr;
}

std::int64_t begin_of_tail(const Rules& rules, const TailWorld& tail, const PartWorld& part, Time time) {
  return units_of(rules.model->material.tracks[tail.on].length) - (length_of(rules, part) - part.x(time));
}

std::vector<const PartWorld*> tails_over(const Rules& rules, const MaterialWorld& world, std::uint32_t track,
                                         std::int64_t position, Time time) {
  std::vector<const PartWorld*> parts;
  for (const TailWorld& tail : world.tails) {
    const PartWorld* const part = across(rules, world, tail, time);
    if (tail.on != track || part == nullptr || begin_of_tail(rules, tail, *part, time) > position) continue;
    parts.push_back(part);
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const PartWorld* a, const PartWorld* b) { return a->x(time) > b->x(time); });
  return parts;
}

bool has_room_between_tails(const Rules& rules, const World& world, const PartTarget& target, Time time) {
  const model::Material& material = rules.model->material;
  if (target.to.location == tables::kOut || !material.is_track(target.to.location)) return true;
  const std::int64_t front = front_at_target(rules, target) + units_of(material.tracks[target.to.location].gap);
  return std::none_of(world.material.tails.begin(), world.material.tails.end(), [&](const TailWorld& tail) {
    if (tail.on != target.to.location || tail.number == target.number) return false;
    const PartWorld* const part = across(rules, world.material, tail, time);
    return part != nullptr && begin_of_tail(rules, tail, *part, time) < front;
  });
}

Time order_due(const Rules& rules, const World& world) {
  Time due = tables::kNever;
  for_pairs(rules, world, world.time,
            [&](const TailWorld& a, const PartWorld& a_part, const TailWorld& b, const PartWorld& b_part) {
              if (b_part.v <= a_part.v) return;
              // The whole ns at or before which they are level, or the next one.
              Time at = world.time + (a_part.x(world.time) - b_part.x(world.time)) / (b_part.v - a_part.v);
              while (!is_before(b, b_part, a, a_part, at)) ++at;
              due = std::min(due, at);
            });
  return due;
}

void drop_tails(const Rules& rules, World& world, Counters& counters) {
  if (world.last_instant >= 0 && world.last_instant < world.time) count_tails(rules, world, counters);
  std::erase_if(world.material.tails,
                [&](const TailWorld& tail) { return across(rules, world.material, tail, world.time) == nullptr; });
}

}  // namespace symplant::reference
