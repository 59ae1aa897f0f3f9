// What a round does with parts (docs/material.md, "One instant").
#include <algorithm>
#include <bit>

#include "support/reference/material.hpp"

namespace symplant::reference {
namespace {

void acted(Round& round, std::size_t stepper, int number) { round.notes.steps[stepper].push_back(number); }

bool use_ends(Round& round) {
  const model::Material& material = round.rules.model->material;
  bool any = false;
  for (std::uint32_t i = 0; i < round.next.material.tracks.size(); ++i) {
    const auto target = leaving(round.rules, round.old, round.next, i);
    if (!target || !has_room(round.rules, round.next, *target, round.next.time)) continue;
    ++round.counters[target->to.location == tables::kOut ? Counted::end_out : Counted::end_with_room];
    if (material.is_track(target->to.location)) ++round.counters[Counted::tail_began];
    move_part(round.rules, round.next, i, 0, *target, false, round.notes.parts);
    any = true;
  }
  return any;
}

bool lies_across(const Round& round, std::uint64_t number) {
  const std::vector<TailWorld>& tails = round.next.material.tails;
  return std::any_of(tails.begin(), tails.end(), [&](const TailWorld& tail) { return tail.number == number; });
}

bool make_transfer(Round& round, std::uint32_t index) {
  const model::Transfer& rules = round.rules.model->material.transfers[index];
  TransferWorld& transfer = round.next.material.transfers[index];
  if (transfer.frozen) return false;
  const bool truth = !rules.condition || holds(*rules.condition, round.old);
  if (truth && !transfer.truth) {
    transfer.permission = true;
    transfer.moved = false;
  }
  transfer.truth = truth;
  if (!truth || (rules.once && !transfer.permission)) return false;
  const auto part = part_to_take(round.rules, round.next, rules.from);
  if (!part) return false;
  const PartWorld& it = round.next.material.at(rules.from.location)[*part];
  const PartTarget target{rules.to, false, it.kind, it.number};
  if (!has_room(round.rules, round.next, target, round.next.time)) return false;
  if (lies_across(round, it.number)) ++round.counters[Counted::tail_moved_away];
  move_part(round.rules, round.next, rules.from.location, *part, target, false, round.notes.parts);
  transfer.permission = false;
  transfer.moved = true;
  ++round.counters[rules.once ? Counted::once_used : Counted::transfer_moved];
  return true;
}

bool do_work(Round& round, std::uint32_t index) {
  const model::Work& rules = round.rules.model->material.work[index];
  WorkWorld& work = round.next.material.work[index];
  if (work.frozen) return false;
  const bool truth = holds(rules.condition, round.old);
  const bool began = truth && !work.truth;
  work.truth = truth;
  if (!began) return false;
  bool any = false;
  for (PartWorld& part : round.next.material.at(rules.at.location)) {
    if (part.kind != rules.from) continue;
    if (rules.at.at != tables::kWhole && !covers(round.rules, part, round.next.time, units_of(rules.at.at))) continue;
    part.kind = rules.to;
    engine::PartChange change{};
    change.what = engine::PartChange::What::changed;
    change.number = part.number;
    change.kind = part.kind;
    change.from = change.to = tables::kOut;
    round.notes.parts.push_back(change);
    ++round.counters[Counted::work_changed];
    any = true;
  }
  return any;
}

/// When a source is due again after a creation.
Time due_again(Round& round, const model::Source& rules, SourceWorld& source) {
  if (rules.count && source.made >= *rules.count) return tables::kNever;
  if (!rules.every) return rules.count ? source.due : tables::kNever;
  Time every = rules.every->a;
  if (rules.every->kind != description::Duration::Kind::fixed) {
    every = draw_duration(round.next.seed, rules.name, 0, source.draws++, *rules.every);
    ++round.counters[Counted::source_draw];
  }
  return later(round.next.time, std::max<Time>(1, every));
}

bool make_of_source(Round& round, std::uint32_t index) {
  const model::Source& rules = round.rules.model->material.sources[index];
  SourceWorld& source = round.next.material.sources[index];
  if (source.frozen || !due_and_allowed(round.rules, round.old, round.next, index)) return false;
  const PartTarget target = next_of_source(round.rules, round.next, index);
  if (!has_room(round.rules, round.next, target, round.next.time)) return false;
  make_part(round.rules, round.next, rules.to, target.kind, false, round.notes.parts);
  ++source.made;
  source.due = due_again(round, rules, source);
  ++round.counters[Counted::source_made];
  return true;
}

/// What a sensor shows of a part, as a level.
std::uint64_t shown_of(const Round& round, const model::PartSensor& sensor, const PartWorld& part) {
  if (sensor.reads == tables::SensorReads::part) return 1;
  const std::uint64_t number =
      sensor.reads == tables::SensorReads::code ? round.rules.model->material.kinds[part.kind].code : part.number;
  const tables::DataType type = round.rules.model->symbols[sensor.symbol].type;
  const bool real = type == tables::DataType::real || type == tables::DataType::lreal;
  return real ? std::bit_cast<std::uint64_t>(static_cast<double>(number)) : number;
}

/// What a sensor shows, as a level.
std::uint64_t sensed(Round& round, std::uint32_t location, const model::PartSensor& sensor) {
  const bool on_track = round.rules.model->material.is_track(location);
  const std::int64_t at = units_of(sensor.at);
  if (on_track) {
    for (const PartWorld* part : tails_over(round.rules, round.next.material, location, at, round.next.time)) {
      if (!sees(sensor, *part)) continue;
      ++round.counters[Counted::tail_seen];
      return shown_of(round, sensor, *part);
    }
  }
  for (const PartWorld& part : round.next.material.at(location)) {
    if (!sees(sensor, part)) continue;
    if (!on_track || covers(round.rules, part, round.next.time, at)) return shown_of(round, sensor, part);
  }
  return 0;
}

bool set_sensors(Round& round, std::uint32_t location, const std::vector<model::PartSensor>& sensors) {
  bool any = false;
  for (const model::PartSensor& sensor : sensors) {
    const std::uint64_t value = round.rules.turned(sensor.symbol, sensed(round, location, sensor));
    if (round.next.symbols[sensor.symbol].value == value) continue;
    for (const std::uint32_t each : round.rules.together(sensor.symbol)) round.next.symbols[each].value = value;
    ++round.counters[round.rules.is_bool(sensor.symbol) ? Counted::sensor_switched : Counted::sensor_number_changed];
    any = true;
  }
  return any;
}

}  // namespace

std::optional<PartTarget> leaving(const Rules& rules, const World& conditions, const World& world,
                                  std::uint32_t track) {
  const model::Track& its = rules.model->material.tracks[track];
  const TrackWorld& there = world.material.tracks[track];
  if (there.frozen || there.parts.empty()) return {};
  const PartWorld& front = there.parts[0];
  const std::int64_t length = units_of(its.length);
  if (front.x(world.time) != length || drive_speed(rules, conditions, track, front) <= 0) return {};
  if (stop_holds_at(rules, conditions, track, length)) return {};
  for (const model::TrackEnd& end : its.ends) {
    if (end.condition && !holds(*end.condition, conditions)) continue;
    return PartTarget{{end.to, tables::kWhole}, true, front.kind, front.number};
  }
  return {};
}

bool due_and_allowed(const Rules& rules, const World& conditions, const World& world, std::uint32_t source) {
  const model::Source& its = rules.model->material.sources[source];
  const SourceWorld& there = world.material.sources[source];
  if (there.due == tables::kNever || there.due > world.time) return false;
  if (its.count && there.made >= *its.count) return false;
  return !its.condition || holds(*its.condition, conditions);
}

PartTarget next_of_source(const Rules& rules, const World& world, std::uint32_t source) {
  const model::Source& its = rules.model->material.sources[source];
  const std::uint64_t made = world.material.sources[source].made;
  return {its.to, false, its.kinds[made % its.kinds.size()], 0};
}

bool run_material(Round& round, int number) {
  const model::Material& material = round.rules.model->material;
  const Steppers stepper = steppers(round.rules);
  bool again = use_ends(round);
  for (std::uint32_t i = 0; i < material.transfers.size(); ++i) {
    if (!make_transfer(round, i)) continue;
    acted(round, stepper.transfers + i, number);
    again = true;
  }
  for (std::uint32_t i = 0; i < material.work.size(); ++i) {
    if (!do_work(round, i)) continue;
    acted(round, stepper.work + i, number);
    again = true;
  }
  for (std::uint32_t i = 0; i < material.sources.size(); ++i) {
    if (!make_of_source(round, i)) continue;
    // A source with a count ends by itself.
    if (!material.sources[i].count) acted(round, stepper.sources + i, number);
    again = true;
  }
  set_speeds(round);
  for (std::uint32_t i = 0; i < material.tracks.size(); ++i) {
    if (set_sensors(round, i, material.tracks[i].sensors)) again = true;
  }
  for (std::uint32_t i = 0; i < material.places.size(); ++i) {
    const auto location = static_cast<std::uint32_t>(material.tracks.size() + i);
    if (set_sensors(round, location, material.places[i].sensors)) again = true;
  }
  return again;
}

}  // namespace symplant::reference
