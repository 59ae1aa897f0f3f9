// How parts move on a track: drives, stops, contacts (docs/material.md, "Movement").
#include <algorithm>
#include <bit>
#include <cmath>

#include "support/reference/malfunctions.hpp"
#include "support/reference/material.hpp"
#include "support/reference/value_rules.hpp"

namespace symplant::reference {
namespace {

double as_double(tables::DataType type, std::uint64_t value) {
  using tables::DataType;
  if (type == DataType::real || type == DataType::lreal) return std::bit_cast<double>(value);
  if (type >= DataType::sint && type <= DataType::lint) return static_cast<double>(static_cast<std::int64_t>(value));
  return static_cast<double>(value);
}

/// It always runs forward, as fast as its symbol or value says.
bool has_no_direction(const model::Drive& drive) {
  return (drive.symbol != kNone || drive.output != kNone) && !drive.forward && !drive.backward;
}

/// What the speed of a drive is multiplied by.
double factor_of(const Rules& rules, const World& conditions, const model::Drive& drive) {
  if (drive.output != kNone) {
    const Input at = output_at(rules, drive.output);
    return conditions.values[at.of].outputs[at.part];
  }
  return as_double(rules.model->symbols[drive.symbol].type, effective(conditions.symbols[drive.symbol]));
}

std::int64_t speed_without_malfunctions(const Rules& rules, const World& conditions, const model::Drive& drive) {
  const bool forward = drive.forward ? holds(*drive.forward, conditions) : has_no_direction(drive);
  const bool backward = drive.backward && holds(*drive.backward, conditions);
  if (forward == backward) return 0;
  std::int64_t speed = drive.speed;
  if (drive.symbol != kNone || drive.output != kNone) {
    const double product = factor_of(rules, conditions, drive) * static_cast<double>(drive.speed);
    constexpr auto kMost = static_cast<double>(tables::kMaxSpeed);
    speed = std::isnan(product) ? 0 : static_cast<std::int64_t>(std::trunc(std::clamp(product, -kMost, kMost)));
  }
  return forward ? speed : -speed;
}

std::int64_t speed_of(const Rules& rules, const World& conditions, const model::Track& track, std::size_t drive) {
  const auto index = static_cast<std::uint32_t>(&track - rules.model->material.tracks.data());
  return slowed_drive(rules, conditions, index, speed_without_malfunctions(rules, conditions, track.drives[drive]));
}

/// Whether the drives before and after the boundary at the end of drive `i` face each other.
bool face(const Rules& rules, const World& conditions, const model::Track& track, std::size_t i) {
  return speed_of(rules, conditions, track, i) > 0 && speed_of(rules, conditions, track, i + 1) < 0;
}

std::size_t drive_of(const model::Track& track, std::int64_t middle) {
  std::size_t drive = 0;
  while (drive + 1 < track.drives.size() && middle >= units_of(track.drives[drive].until)) ++drive;
  return drive;
}

bool between_facing_drives(const Rules& rules, const World& conditions, const model::Track& track,
                           std::int64_t middle) {
  for (std::size_t i = 0; i + 1 < track.drives.size(); ++i) {
    if (units_of(track.drives[i].until) == middle && face(rules, conditions, track, i)) return true;
  }
  return false;
}

/// The two passes over a track.
struct Speeds {
  Round& round;
  std::uint32_t index;
  const model::Track& track = round.rules.model->material.tracks[index];
  TrackWorld& world = round.next.material.tracks[index];
  Time now = round.next.time;
  std::vector<std::int64_t> v = std::vector<std::int64_t>(world.parts.size());

  bool touches_ahead(std::size_t i) const {
    return i > 0 && world.parts[i].x(now) >= contact_with(round.rules, world, track, i - 1, now);
  }

  std::int64_t forward(std::size_t i, std::int64_t w) {
    const PartWorld& part = world.parts[i];
    if (w <= 0) return w;
    if (part.x(now) >= units_of(track.length)) return 0;
    if (stop_holds_at(round.rules, round.old, index, part.x(now))) {
      if (part.v != 0) ++round.counters[Counted::stop_caught];
      return 0;
    }
    if (!touches_ahead(i)) return w;
    const std::int64_t limited = std::min(w, std::max<std::int64_t>(v[i - 1], 0));
    if (limited < w && limited != part.v) ++round.counters[Counted::part_touched];
    if (limited > 0 && part.v == 0 && world.parts[i - 1].v == 0) ++round.counters[Counted::queue_released];
    return limited;
  }

  std::int64_t backward(std::size_t i, std::int64_t w) {
    const PartWorld& part = world.parts[i];
    if (w >= 0) return w;
    const std::int64_t tail = part.x(now) - length_of(round.rules, part);
    if (tail <= 0) return 0;
    if (stop_holds_at(round.rules, round.old, index, tail)) {
      if (part.v != 0) ++round.counters[Counted::stop_caught_backward];
      return 0;
    }
    const std::size_t behind = i + 1;
    if (behind == v.size() || !touches_ahead(behind)) return w;
    const std::int64_t limited = std::max(w, std::min<std::int64_t>(v[behind], 0));
    if (limited > w && limited != part.v) ++round.counters[Counted::part_touched_backward];
    return limited;
  }

  void run() {
    for (std::size_t i = 0; i < v.size(); ++i) {
      v[i] = forward(i, drive_speed(round.rules, round.old, index, world.parts[i]));
      const bool facing =
          between_facing_drives(round.rules, round.old, track, middle_of(round.rules, world.parts[i], now));
      if (facing && !world.frozen && world.parts[i].v != 0) ++round.counters[Counted::facing_stopped];
    }
    for (std::size_t i = v.size(); i > 0; --i) v[i - 1] = backward(i - 1, v[i - 1]);
    for (std::size_t i = 0; i < v.size(); ++i) {
      PartWorld& part = world.parts[i];
      if (part.v == v[i]) continue;
      if (v[i] < 0) ++round.counters[Counted::moved_backward];
      const std::int64_t middle = middle_of(round.rules, part, now);
      if (has_no_direction(track.drives[drive_of(track, middle)])) ++round.counters[Counted::moved_without_direction];
      part.rebase(part.x(now), now);
      part.v = v[i];
    }
  }
};

/// Where a part that moves forward must be; its x if it overshot nothing.
std::int64_t put_forward(const Rules& rules, const World& world, const model::Track& track, const TrackWorld& its,
                         std::size_t i) {
  const PartWorld& part = its.parts[i];
  const std::int64_t x = part.x(world.time);
  const std::int64_t before = part.x(world.last_instant);
  const std::int64_t half = length_of(rules, part) / 2;
  std::int64_t put = std::min(x, units_of(track.length));
  const auto passed = [&](std::int64_t position) {
    if (before <= position && position < x) put = std::min(put, position);
  };
  for (std::size_t j = 0; j < its.held.size(); ++j) {
    if (its.held[j]) passed(units_of(track.stops[j].at));
  }
  for (std::size_t j = 0; j < its.facing.size(); ++j) {
    if (its.facing[j]) passed(units_of(track.drives[j].until) + half);
  }
  if (i > 0) put = std::min(put, contact_with(rules, its, track, i - 1, world.time));
  return std::max(put, part.x0);
}

std::int64_t put_backward(const Rules& rules, const World& world, const model::Track& track, const TrackWorld& its,
                          std::size_t i) {
  const PartWorld& part = its.parts[i];
  const std::int64_t x = part.x(world.time);
  const std::int64_t before = part.x(world.last_instant);
  const std::int64_t length = length_of(rules, part);
  std::int64_t put = std::max(x, length);
  const auto passed = [&](std::int64_t position) {
    if (x < position && position <= before) put = std::max(put, position);
  };
  for (std::size_t j = 0; j < its.held.size(); ++j) {
    if (its.held[j]) passed(units_of(track.stops[j].at) + length);
  }
  for (std::size_t j = 0; j < its.facing.size(); ++j) {
    if (its.facing[j]) passed(units_of(track.drives[j].until) + length / 2);
  }
  if (i + 1 < its.parts.size()) {
    put = std::max(put, its.parts[i + 1].x(world.time) + units_of(track.gap) + length);
  }
  return std::min(put, part.x0);
}

void count_drives(const Rules& rules, const World& world, std::uint32_t track, Counters& counters) {
  const model::Track& its = rules.model->material.tracks[track];
  for (const PartWorld& part : world.material.tracks[track].parts) {
    const std::int64_t middle = middle_of(rules, part, world.time);
    if (part.v != 0 && drive_of(its, middle) != drive_of(its, middle - part.v)) ++counters[Counted::drive_entered];
  }
}

}  // namespace

std::int64_t drive_speed(const Rules& rules, const World& conditions, std::uint32_t track, const PartWorld& part) {
  const model::Track& its = rules.model->material.tracks[track];
  // A frozen track does not move its parts. Positions are those of now.
  if (conditions.material.tracks[track].frozen) return 0;
  const std::int64_t middle = middle_of(rules, part, conditions.time);
  if (between_facing_drives(rules, conditions, its, middle)) return 0;
  return speed_of(rules, conditions, its, drive_of(its, middle));
}

bool stop_holds_at(const Rules& rules, const World& conditions, std::uint32_t track, std::int64_t position) {
  const std::vector<model::Stop>& stops = rules.model->material.tracks[track].stops;
  return std::any_of(stops.begin(), stops.end(), [&](const model::Stop& stop) {
    return units_of(stop.at) == position && holds(stop.condition, conditions);
  });
}

std::int64_t contact_with(const Rules& rules, const TrackWorld& track, const model::Track& its, std::size_t ahead,
                          Time time) {
  return track.parts[ahead].x(time) - length_of(rules, track.parts[ahead]) - units_of(its.gap);
}

void set_speeds(Round& round) {
  const model::Material& material = round.rules.model->material;
  for (std::uint32_t i = 0; i < material.tracks.size(); ++i) {
    const model::Track& track = material.tracks[i];
    TrackWorld& world = round.next.material.tracks[i];
    for (std::size_t j = 0; j < track.stops.size(); ++j) world.held[j] = holds(track.stops[j].condition, round.old);
    for (std::size_t j = 0; j < world.facing.size(); ++j) world.facing[j] = face(round.rules, round.old, track, j);
    Speeds{round, i}.run();
  }
}

// Parts that move forward first, each after the part ahead of it; then the others. Only what moved since the last
// instant can have overshot.
void put_overshot(const Rules& rules, World& world, std::uint32_t track, Counters& counters) {
  if (world.last_instant == world.time) return;
  const model::Track& its = rules.model->material.tracks[track];
  TrackWorld& there = world.material.tracks[track];
  const auto put = [&](PartWorld& part, std::int64_t position) {
    if (position == part.x(world.time)) return;
    ++counters[Counted::overshot];
    part.rebase(position, world.time);
  };
  for (std::size_t i = 0; i < there.parts.size(); ++i) {
    if (there.parts[i].v > 0) put(there.parts[i], put_forward(rules, world, its, there, i));
  }
  for (std::size_t i = there.parts.size(); i > 0; --i) {
    if (there.parts[i - 1].v < 0) put(there.parts[i - 1], put_backward(rules, world, its, there, i - 1));
  }
}

void begin_instant_of_parts(const Rules& rules, World& world, Counters& counters, InstantNotes& notes) {
  constexpr int kMostInstants = 10'000;
  for (std::uint32_t i = 0; i < world.material.tracks.size(); ++i) {
    TrackWorld& track = world.material.tracks[i];
    put_overshot(rules, world, i, counters);
    count_drives(rules, world, i, counters);
    if (track.frozen || track.own_due != world.time) continue;
    if (track.own_instants > kMostInstants) {
      track.frozen = true;
      ++counters[Counted::track_frozen];
      notes.loops.push_back({static_cast<std::uint32_t>(steppers(rules).tracks + i)});
      continue;
    }
    if (track.window < 0 || world.time - track.window >= tables::kMillisecond) {
      track.window = world.time;
      track.own_instants = 0;
    }
    ++track.own_instants;
  }
  drop_tails(rules, world, counters);
}

}  // namespace symplant::reference
