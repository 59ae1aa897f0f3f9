// Random tracks and places: drives, stops, sensors, ends.
#include <algorithm>

#include "property/random_material.hpp"

namespace symplant::property {
namespace {

using description::GivenDrive;
using description::GivenTrack;

/// A position on a track, most on the plan's grid.
std::int64_t position_on(MaterialPlan& plan, const GivenTrack& track) {
  const auto cells = static_cast<std::size_t>(track.length / plan.unit);
  const auto position = static_cast<std::int64_t>(plan.dice.below(cells + 1)) * plan.unit;
  if (plan.dice.percent(12)) return track.length;
  return plan.dice.percent(15) ? std::min(track.length, position + 1) : position;
}

/// In um/s. At the first one a part passes a unit in 10 ms; the odd ones overshoot.
std::int64_t random_speed(MaterialPlan& plan) {
  const std::int64_t whole = 100 * plan.unit;
  const std::vector<std::int64_t> speeds = {whole, whole, whole, 2 * whole, whole / 2, 3 * whole, 7 * whole / 3 + 1};
  return std::min(tables::kMaxSpeed, plan.dice.percent(5) ? tables::kMaxSpeed : plan.dice.pick(speeds));
}

description::GivenSpeed speed_of_drive(MaterialPlan& plan) {
  if (!plan.dice.percent(22)) return {random_speed(plan), ""};
  static const std::vector<std::string> kTypes = {"INT", "UINT", "REAL", "LREAL", "DINT", "LINT"};
  const std::string name = "SPEED" + std::to_string(plan.rows);
  const std::string& type = plan.dice.pick(kTypes);
  plan.row(name, type, !plan.dice.percent(25));
  if (plan.dice.percent(60)) plan.text.rows.back().initial = "2";
  return {plan.dice.percent(20) ? 1 : 50 * plan.unit, name};
}

GivenDrive random_drive(MaterialPlan& plan, bool reversed) {
  GivenDrive drive;
  const std::size_t kind = plan.dice.below(100);
  std::string main = kind < 68 ? plan.switch_atom() : kind < 90 ? plan.condition() : "";
  std::string other = plan.dice.percent(40) ? plan.condition() : "";
  if (plan.dice.percent(12)) other = "not (" + main + ")";
  if (main.empty() && (other.empty() || other.starts_with("not ("))) other = plan.condition();
  drive.forward = reversed ? other : main;
  drive.backward = reversed ? main : other;
  drive.speed = speed_of_drive(plan);
  if (!drive.speed.of.empty() && plan.dice.percent(40)) {
    drive.forward.clear();
    drive.backward.clear();
  }
  return drive;
}

void draw_drives(MaterialPlan& plan, GivenTrack& track) {
  const std::size_t cells = static_cast<std::size_t>(track.length / plan.unit);
  const std::size_t count = 1 + plan.dice.below(std::min<std::size_t>(3, cells - 1));
  const bool all_reversed = plan.dice.percent(12);
  std::int64_t before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    track.drives.push_back(random_drive(plan, all_reversed));
    if (i + 1 == count) break;
    const auto most = static_cast<std::size_t>((track.length - before) / plan.unit) - (count - i - 1);
    before += static_cast<std::int64_t>(1 + plan.dice.below(most)) * plan.unit;
    if (before >= track.length) break;
    track.drives.back().until = before;
  }
  track.drives.back().until.reset();
  if (track.drives.size() > 1 && plan.dice.percent(8)) track.drives[track.drives.size() - 2].until = track.length;
  if (track.drives.size() < 2 || !plan.dice.percent(30)) return;
  // Drives that face each other most of the time.
  track.drives[0].forward = plan.switch_atom();
  track.drives[0].backward.clear();
  track.drives[1].forward.clear();
  track.drives[1].backward = plan.switch_atom();
}

/// A symbol of a sensor, with its row. Some have names of devices, which they do not belong to.
std::string sensor_symbol(MaterialPlan& plan, bool number) {
  static const std::vector<std::string> kTypes = {"UINT", "UDINT", "INT", "WORD", "DINT", "LINT", "DWORD"};
  if (number) {
    const std::string name = "CODE" + std::to_string(plan.rows);
    plan.row(name, plan.dice.pick(kTypes), false);
    plan.number_sensors.push_back(name);
    return name;
  }
  std::string name = "PE" + std::to_string(plan.rows);
  if (plan.text.naming.empty() && plan.dice.percent(30)) {
    name = "L0_P_D" + std::to_string(plan.dice.below(3)) + "_I_SENSED" + std::to_string(plan.rows);
  }
  plan.row(name, "BOOL", false);
  plan.bit_sensors.push_back(name);
  return name;
}

description::GivenSensor random_sensor(MaterialPlan& plan) {
  description::GivenSensor given;
  const bool number = plan.dice.percent(30);
  given.symbol = sensor_symbol(plan, number);
  if (number) given.reads = plan.dice.percent(50) ? tables::SensorReads::code : tables::SensorReads::number;
  if (plan.dice.percent(35)) given.kinds.push_back(plan.dice.pick(plan.material().kinds).name);
  if (number || !plan.dice.percent(25)) return given;
  if (plan.dice.percent(50) && given.symbol.starts_with("PE")) {
    given.inverted = true;
  } else if (given.symbol.starts_with("PE")) {
    plan.text.description.inverted.push_back(given.symbol);
  }
  return given;
}

std::string target_of_end(MaterialPlan& plan, std::size_t track) {
  const std::size_t kind = plan.dice.below(100);
  if (kind < 25) return "out";
  if (kind < 45 && !plan.places.empty()) return plan.dice.pick(plan.places);
  return plan.tracks[(track + 1) % plan.tracks.size()];
}

}  // namespace

void draw_tracks(MaterialPlan& plan) {
  std::int64_t longest = 2 * plan.unit;
  for (const description::GivenKind& kind : plan.material().kinds) longest = std::max(longest, kind.length);
  for (const std::string& name : plan.tracks) {
    GivenTrack& track = plan.material().tracks.emplace_back();
    track.name = name;
    track.length = longest + plan.unit * static_cast<std::int64_t>(plan.dice.below(plan.dice.percent(60) ? 6 : 20));
    if (plan.dice.percent(10)) ++track.length;
    if (plan.dice.percent(30)) track.gap = plan.dice.percent(50) ? plan.unit / 2 : plan.unit;
  }
  // The sensors first: conditions name them.
  for (GivenTrack& track : plan.material().tracks) {
    for (std::size_t i = plan.dice.below(4); i > 0; --i) {
      track.sensors.push_back(random_sensor(plan));
      track.sensors.back().at = position_on(plan, track);
    }
  }
  for (std::size_t i = 0; i < plan.tracks.size(); ++i) {
    GivenTrack& track = plan.material().tracks[i];
    draw_drives(plan, track);
    for (std::size_t k = plan.dice.below(3); k > 0; --k) {
      track.stops.push_back({position_on(plan, track), plan.dice.percent(50) ? plan.switch_atom() : plan.condition()});
      if (plan.dice.percent(60)) track.stops.back().when = plan.dice.pick(plan.switches);
    }
    if (plan.dice.percent(10)) continue;
    if (plan.tracks.size() > 1 && plan.dice.percent(15)) {
      // Parts go to two tracks, so that a part may pass the tail of another one.
      const std::string& first = plan.tracks[(i + 1) % plan.tracks.size()];
      track.ends.push_back({first, "not " + first + ".part"});
      track.ends.push_back({plan.tracks[(i + 2) % plan.tracks.size()], ""});
      continue;
    }
    if (plan.dice.percent(30)) track.ends.push_back({target_of_end(plan, i), plan.condition()});
    track.ends.push_back({target_of_end(plan, i), plan.dice.percent(25) ? plan.condition() : ""});
  }
}

void draw_places(MaterialPlan& plan) {
  for (const std::string& name : plan.places) {
    description::GivenPlace& place = plan.material().places.emplace_back();
    place.name = name;
    place.holds = 1 + static_cast<std::uint32_t>(plan.dice.below(3));
    if (plan.dice.percent(60)) place.sensors.push_back(random_sensor(plan));
  }
}

}  // namespace symplant::property
