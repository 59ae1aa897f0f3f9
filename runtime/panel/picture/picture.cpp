// What the plant looks like now, as JSON.
#include "symplant/panel/picture/picture.hpp"

#include <algorithm>
#include <iterator>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/trace/influences.hpp"
#include "symplant/trace/malfunction_text.hpp"
#include "symplant/trace/unit_activity.hpp"

namespace symplant::panel {
namespace {

using trace::Record;

enum : unsigned { kIsMoving = 1, kIsMidway = 2, kIsDisabled = 4, kIsFrozen = 8, kHasMalfunction = 16 };
enum : unsigned { kIsForced = 1, kIsOverridden = 2 };

unsigned flags_of(const plant::UnitView& view) {
  return (view.moving ? kIsMoving : 0U) | (view.stopped_midway ? kIsMidway : 0U) | (view.disabled ? kIsDisabled : 0U) |
         (view.frozen ? kIsFrozen : 0U);
}

using trace::runs;

/// Appends an array of `count` arrays, whose content `put_one` appends by their number.
template <class PutOne>
void put_array(std::string& json, std::string_view key, std::size_t count, PutOne put_one) {
  put_key(json, key);
  json += '[';
  for (std::size_t i = 0; i < count; ++i) {
    put_comma(json);
    json += '[';
    put_one(static_cast<std::uint32_t>(i));
    json += ']';
  }
  json += ']';
}

/// The same for some rows of a table, with their indexes first.
template <class PutOne>
void put_some(std::string& json, std::string_view key, const std::vector<std::uint32_t>& rows, PutOne put_one) {
  if (rows.empty()) return;
  put_array(json, key, rows.size(), [&](std::uint32_t i) {
    put(json, "{},", rows[i]);
    put_one(rows[i]);
  });
}

}  // namespace

Picture::Picture(const trace::PlantNames& names, const trace::History& history)
    : names_(names),
      history_(history),
      motions_(names.tables().units.size()),
      tracks_(names.tables().material.tracks.size()),
      track_states_(names.tables(), history),
      values_(names.tables()),
      malfunctions_(names.tables()),
      devices_(names.tables().units.size()),
      symbols_(names.tables().symbols.size()),
      locations_(names.tables().material.locations()) {}

std::vector<std::uint32_t> Picture::Marks::of(Role role) const {
  std::vector<std::uint32_t> seen;
  seen.reserve(list.size());
  std::copy_if(list.begin(), list.end(), std::back_inserter(seen),
               [&](std::uint32_t index) { return sees_all(role) || shown[index]; });
  return seen;
}

void Picture::apply(const Record& record) {
  switch (record.kind) {
    case Record::Kind::change:
      symbols_.mark(record.of);
      if (const std::uint32_t unit = names_.tables().symbols[record.of].unit; unit != tables::kNone) {
        devices_.mark(unit);  // its commands may have changed
      }
      break;
    case Record::Kind::unit:
      devices_.mark(record.of);
      set_motion(record);
      break;
    case Record::Kind::part_move: {
      const std::uint32_t from = static_cast<std::uint32_t>(record.value >> 32);
      const std::uint32_t to = static_cast<std::uint32_t>(record.value);
      const bool changed = from == tables::kNone && to == tables::kNone;
      for (std::uint32_t location = 0; location < locations_.marked.size(); ++location) {
        // Parts of tracks have other records.
        const bool concerned = changed || location == from || location == to;
        if (concerned && !names_.tables().material.is_track(location)) locations_.mark(location);
      }
      break;
    }
    case Record::Kind::track:
      track_ = &tracks_[record.of];
      track_->at = record.time;
      track_->parts.clear();
      locations_.mark(record.of);
      break;
    case Record::Kind::part_at:
      track_->parts.push_back({record.value, record.of, 0, 0});
      break;
    case Record::Kind::part_speed:
      track_->parts.back().x = static_cast<std::int64_t>(record.value);
      track_->parts.back().v = static_cast<std::int32_t>(record.of);
      break;
    case Record::Kind::value:
      values_.apply(record);
      break;
    case Record::Kind::malfunction:
      set_malfunction(record);
      break;
    default:
      break;
  }
}

void Picture::set_malfunction(const Record& record) {
  malfunctions_.change(record.of, record.more);
  values_.change(record.of, record.more);
  malfunctions_changed_ = true;
  const trace::ActsOn on = trace::acts_on(names_.tables(), record.of);
  for (const std::uint32_t unit : on.units) devices_.mark(unit, false);
  for (const std::uint32_t symbol : on.symbols) symbols_.mark(symbol, false);
}

/// A record has what is left of a move. Its whole time is the same at its start; a move that stopped and goes on keeps
/// it; one that turned round has come as far in the time left as the other one had.
void Picture::set_motion(const Record& record) {
  Motion& motion = motions_[record.of];
  const Motion before = motion;
  const plant::UnitView view = trace::unpack_unit(record.value);
  motion = {record.time, trace::remaining_of(record.value), 0, view.state, view.target, runs(view)};
  if (!view.moving) return;
  const tables::Time left = before.remaining - (before.runs ? std::min(record.time - before.at, before.remaining) : 0);
  motion.whole = motion.remaining;
  if (before.whole == 0) return;
  if (before.from == view.state && before.to == view.target) motion.whole = std::max(before.whole, motion.remaining);
  if (before.from == view.target && before.to == view.state && left < before.whole) {
    const double travelled = static_cast<double>(before.whole - left) / static_cast<double>(before.whole);
    motion.whole =
        std::max(motion.remaining, static_cast<tables::Time>(static_cast<double>(motion.remaining) / travelled));
  }
}

void Picture::load(const plant::Plant& plant) {
  for (std::uint32_t unit = 0; unit < motions_.size(); ++unit) {
    const plant::UnitView view = plant.unit(unit);
    motions_[unit] = {plant.now(), view.remaining, view.whole, view.state, view.target, runs(view)};
    devices_.mark(unit);
  }
  for (std::uint32_t track = 0; track < tracks_.size(); ++track) {
    tracks_[track] = {plant.now(), {}};
    for (std::uint32_t i = 0; i < plant.parts(track); ++i) {
      const plant::PartView part = plant.part(track, i);
      const plant::PartMotion motion = plant.motion(track, i);
      tracks_[track].parts.push_back({part.number, part.kind, motion.v, motion.x});
    }
  }
  values_.load(plant);
  malfunctions_.clear();
  malfunctions_changed_ = true;
  for (const engine::ActiveMalfunction& one : plant.active_malfunctions()) malfunctions_.change(one.number, true);
  for (std::uint32_t symbol = 0; symbol < symbols_.marked.size(); ++symbol) symbols_.mark(symbol);
  for (std::uint32_t location = 0; location < locations_.marked.size(); ++location) locations_.mark(location);
}

void Picture::put_device(std::string& json, std::uint32_t unit, tables::Time now, Role role) const {
  const plant::UnitView view = history_.unit(unit);
  const Motion& motion = motions_[unit];
  const tables::Time passed = runs(view) ? std::min(now - motion.at, motion.remaining) : 0;
  unsigned flags = flags_of(view) | (sees_all(role) && malfunctions_.unit(unit) ? +kHasMalfunction : 0U);
  if (!sees_all(role) && malfunctions_.unit(unit) && !trace::is_disabled_by_device(unit, names_, history_)) {
    flags &= ~unsigned{kIsDisabled};  // a malfunction alone disables it
  }
  put(json, "{},{},{},{},{},{},{}", view.state, view.moving ? view.target : view.state, flags,
      trace::is_blocked(names_, history_, unit) ? 1 : 0, history_.unit_since(unit),
      view.moving ? motion.remaining - passed : 0, view.moving ? motion.whole : 0);
}

void Picture::put_symbol(std::string& json, std::uint32_t symbol, Role role) const {
  json += trace::json_value(names_.tables().symbols[symbol].type(), history_.value(symbol));
  const unsigned flags = (history_.forced_since(symbol) >= 0 ? +kIsForced : 0U) |
                         (sees_all(role) && malfunctions_.symbol(symbol) ? +kIsOverridden : 0U);
  put(json, ",{},{}", flags, history_.since(symbol));
}

void Picture::put_track(std::string& json, std::uint32_t track) const {
  put(json, "{},[", tracks_[track].at);
  for (const PartSpot& part : tracks_[track].parts) {
    put_comma(json);
    put(json, "[{},{},{},{}]", part.number, part.kind, part.x, part.v);
  }
  json += "],";
  track_states_.put(json, track);
}

/// Stops and drives may have changed with any symbol or device.
void Picture::look_at_tracks(tables::Time now) {
  if (tracks_.empty() || !has_changes()) return;
  track_states_.look(now, values_.numbers(), [this](std::uint32_t track) { locations_.mark(track); });
}

void Picture::put_place(std::string& json, std::uint32_t place) const {
  for (const trace::History::Part& part : history_.parts_at(static_cast<std::uint32_t>(tracks_.size()) + place)) {
    put_comma(json);
    put(json, "[{},{}]", part.number, part.kind);
  }
}

void Picture::put_all(std::string& json, tables::Time now, Role role) {
  look_at_tracks(now);
  put_array(json, "devices", motions_.size(), [&](std::uint32_t unit) { put_device(json, unit, now, role); });
  put_array(json, "symbols", symbols_.marked.size(), [&](std::uint32_t symbol) { put_symbol(json, symbol, role); });
  put_array(json, "tracks", tracks_.size(), [&](std::uint32_t track) { put_track(json, track); });
  put_array(json, "places", locations_.marked.size() - tracks_.size(),
            [&](std::uint32_t place) { put_place(json, place); });
  values_.put_all(json, role);
  if (sees_all(role)) put_malfunctions(json);
}

void Picture::put_malfunctions(std::string& json) const {
  const auto& active = history_.malfunctions();
  put_array(json, "malfunctions", active.size(), [&](std::uint32_t i) {
    put_text(json, names_.malfunction(active[i].number));
    put(json, ",{},\"{}\"", active[i].since, trace::malfunction_by(active[i].by));
  });
}

void Picture::put_changes(std::string& json, tables::Time now, Role role) {
  look_at_tracks(now);
  std::vector<std::uint32_t> tracks;
  std::vector<std::uint32_t> places;
  const auto first_place = static_cast<std::uint32_t>(tracks_.size());
  for (const std::uint32_t location : locations_.list) {
    if (location < first_place) {
      tracks.push_back(location);
    } else {
      places.push_back(location - first_place);
    }
  }
  put_some(json, "devices", devices_.of(role), [&](std::uint32_t unit) { put_device(json, unit, now, role); });
  put_some(json, "symbols", symbols_.of(role), [&](std::uint32_t symbol) { put_symbol(json, symbol, role); });
  put_some(json, "tracks", tracks, [&](std::uint32_t track) { put_track(json, track); });
  put_some(json, "places", places, [&](std::uint32_t place) {
    json += '[';
    put_place(json, place);
    json += ']';
  });
  values_.put_changes(json, role);
  if (malfunctions_changed_ && sees_all(role)) put_malfunctions(json);
}

void Picture::forget_changes() {
  malfunctions_changed_ = false;
  devices_.clear();
  symbols_.clear();
  locations_.clear();
  values_.forget_changes();
}

}  // namespace symplant::panel
