// Each malfunction of a run from its start to its end.
#include "symplant/panel/training/malfunction_runs.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "symplant/tables/malfunction_numbers.hpp"

namespace symplant::panel {
namespace {

using tables::Time;
using trace::Record;

void sort(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

bool has(const std::vector<std::uint32_t>& sorted, std::uint32_t one) {
  return std::binary_search(sorted.begin(), sorted.end(), one);
}

bool has_any(const std::vector<std::uint32_t>& sorted, const std::vector<std::uint32_t>& of) {
  return std::any_of(of.begin(), of.end(), [&](std::uint32_t one) { return has(sorted, one); });
}

}  // namespace

MalfunctionRuns::MalfunctionRuns(const trace::PlantNames& names, const trace::History& history)
    : names_(names),
      history_(history),
      watched_symbols_(names.tables().symbols.size()),
      watched_units_(names.tables().units.size()),
      watched_tracks_(names.tables().material.tracks.size()),
      units_(names.tables().units.size()) {
  set_back(kNotYet);
}

void MalfunctionRuns::apply(const Record& record) {
  switch (record.kind) {
    case Record::Kind::change: {
      changed_symbols_.push_back(record.of);
      const std::uint32_t unit = names_.tables().symbols[record.of].unit;
      const bool is_watched = watched_symbols_[record.of] != 0 || (unit != tables::kNone && watched_units_[unit] != 0);
      if (!is_watched) break;
      look(record.time, [&](const Waiting& waiting) {
        return has(waiting.symbols, record.of) || (has(waiting.units, unit) && is_commanded_elsewhere(unit));
      });
      break;
    }
    case Record::Kind::unit:
      unit_changed(record);
      break;
    case Record::Kind::track:
      changed_tracks_.push_back(record.of);
      if (watched_tracks_[record.of] == 0) break;
      look(record.time, [&](const Waiting& waiting) { return has(waiting.tracks, record.of); });
      break;
    case Record::Kind::malfunction:
      record.more ? start(record.of, record.time) : end(record.of, record.time);
      break;
    default:
      break;
  }
  if (record.last) instant_ended();
}

void MalfunctionRuns::instant_ended() {
  changed_symbols_.clear();
  changed_units_.clear();
  changed_tracks_.clear();
  affected_.clear();
}

/// Notes the first effect of each run for which `is_effect(waiting)` holds.
template <class IsEffect>
void MalfunctionRuns::look(Time time, IsEffect is_effect) {
  std::erase_if(waiting_, [&](const Waiting& waiting) {
    if (!is_effect(waiting)) return false;
    count(waiting, false);
    run_of(waiting.n)->effect = time;
    affected_.push_back(waiting.n);
    ++version_;
    return true;
  });
}

void MalfunctionRuns::unit_changed(const Record& record) {
  const std::uint32_t unit = record.of;
  const plant::UnitView before = trace::unpack_unit(units_[unit]);
  const plant::UnitView now = trace::unpack_unit(record.value);
  units_[unit] = static_cast<std::uint32_t>(record.value & ((std::uint64_t{1} << trace::kUnitBits) - 1));
  const bool has_moved = now.state != before.state || now.target != before.target;
  if (has_moved) changed_units_.push_back(unit);
  if (watched_units_[unit] == 0) return;
  const tables::TypeRow& type = names_.tables().types[names_.tables().units[unit].type];
  const std::span<const tables::EventMasks> switches = now.moving ? type.leave : type.enter;
  look(record.time, [&](const Waiting& waiting) {
    if (has(waiting.units, unit)) return has_moved || now.moving || is_commanded_elsewhere(unit);
    return has_moved && has(waiting.driven, unit) && now.state < switches.size() &&
           is_masked(waiting, unit, switches[now.state]);
  });
}

/// Whether a unit switches one of its events that a malfunction decides, but the event does not follow.
bool MalfunctionRuns::is_masked(const Waiting& waiting, std::uint32_t unit, const tables::EventMasks& switched) const {
  const tables::PlantTables& tables = names_.tables();
  return std::any_of(waiting.symbols.begin(), waiting.symbols.end(), [&](std::uint32_t symbol) {
    const tables::SymbolRow& row = tables.symbols[symbol];
    if (row.unit != unit || !tables::MalfunctionNumbers(tables).is_bool_event(symbol)) return false;
    const std::uint64_t bit = std::uint64_t{1} << (row.index - tables.units[unit].event_bit);
    const bool shown = (history_.value(symbol) != 0) != row.inverted();
    return ((switched.on & bit) != 0 && !shown) || ((switched.off & bit) != 0 && shown);
  });
}

/// Whether a command leads to a state other than that in which the unit is, or from which it moves.
bool MalfunctionRuns::is_commanded_elsewhere(std::uint32_t unit) const {
  const tables::TypeRow& type = names_.tables().types[names_.tables().units[unit].type];
  const std::uint8_t state = history_.unit(unit).state;
  bool is_commanded = false;
  std::size_t operation = 0;
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    if (!names_.is_operation(symbol)) continue;
    const std::uint8_t target = type.operation_targets[operation++];
    if (!history_.commands(symbol)) continue;
    is_commanded = true;
    if (target != state) return true;
  }
  return !is_commanded && type.rest != tables::kNoState && type.rest != state;
}

/// Whether a malfunction that acts on a device or a track has an effect now, without a change.
bool MalfunctionRuns::acts_now(const Waiting& waiting) const {
  return waiting.at_once || std::any_of(waiting.units.begin(), waiting.units.end(), [&](std::uint32_t unit) {
           return history_.unit(unit).moving || is_commanded_elsewhere(unit);
         });
}

bool MalfunctionRuns::shows_in_instant(const Waiting& waiting) const {
  return has_any(waiting.symbols, changed_symbols_) || has_any(waiting.units, changed_units_) ||
         has_any(waiting.tracks, changed_tracks_);
}

void MalfunctionRuns::start(std::uint32_t malfunction, Time time) {
  ++version_;
  runs_.push_back({next_++, malfunction, time, kNotYet, kNotYet, {}});
  watch(waiting_for(runs_.back()));
  look(time, [&](const Waiting& waiting) {
    return waiting.n == runs_.back().n && (acts_now(waiting) || shows_in_instant(waiting));
  });
  if (runs_.size() > kMostRuns) forget_oldest();
}

void MalfunctionRuns::end(std::uint32_t malfunction, Time time) {
  const auto is_it = [&](const MalfunctionRun& run) { return run.malfunction == malfunction && run.end == kNotYet; };
  const auto run = std::find_if(runs_.begin(), runs_.end(), is_it);
  if (run == runs_.end()) return;
  ++version_;
  run->end = time;
  if (std::find(affected_.begin(), affected_.end(), run->n) != affected_.end() && run->start != time) {
    run->effect = kNotYet;  // it is the end itself that shows
  }
  std::erase_if(waiting_, [&](const Waiting& waiting) {
    if (waiting.n != run->n) return false;
    count(waiting, false);
    return true;
  });
}

void MalfunctionRuns::forget_oldest() {
  std::erase_if(waiting_, [&](const Waiting& waiting) {
    if (waiting.n != runs_.front().n) return false;
    count(waiting, false);
    return true;
  });
  runs_.pop_front();
}

MalfunctionRun* MalfunctionRuns::run_of(std::uint64_t n) {
  const auto run = std::find_if(runs_.begin(), runs_.end(), [&](const MalfunctionRun& each) { return each.n == n; });
  return run == runs_.end() ? nullptr : &*run;
}

MalfunctionRuns::Waiting MalfunctionRuns::waiting_for(const MalfunctionRun& run) const {
  const tables::PlantTables& tables = names_.tables();
  Waiting waiting;
  waiting.n = run.n;
  trace::ActsOn on = trace::acts_on(tables, run.malfunction);
  waiting.symbols = std::move(on.symbols);
  waiting.units = std::move(on.units);
  if (tables::MalfunctionNumbers(tables).is_written(run.malfunction)) {
    for (const tables::EffectRow& effect : tables.malfunctions.effects_of(run.malfunction)) {
      const auto tracks = tables.malfunctions.tracks_of(effect);
      waiting.tracks.insert(waiting.tracks.end(), tracks.begin(), tracks.end());
      waiting.at_once = waiting.at_once || effect.kind == tables::MalfunctionKind::lose ||
                        effect.kind == tables::MalfunctionKind::set;
    }
  }
  for (const std::uint32_t symbol : waiting.symbols) {
    if (tables.symbols[symbol].unit != tables::kNone) waiting.driven.push_back(tables.symbols[symbol].unit);
  }
  sort(waiting.symbols);
  sort(waiting.driven);
  sort(waiting.units);
  sort(waiting.tracks);
  return waiting;
}

void MalfunctionRuns::watch(Waiting waiting) {
  count(waiting, true);
  waiting_.push_back(std::move(waiting));
}

void MalfunctionRuns::count(const Waiting& waiting, bool more) {
  const auto add = [more](std::vector<std::uint32_t>& counts, const std::vector<std::uint32_t>& of) {
    for (const std::uint32_t one : of) more ? ++counts[one] : --counts[one];
  };
  add(watched_symbols_, waiting.symbols);
  add(watched_units_, waiting.units);
  add(watched_units_, waiting.driven);
  add(watched_tracks_, waiting.tracks);
}

void MalfunctionRuns::acted(std::uint32_t trainee, Time time) {
  for (MalfunctionRun& run : runs_) {
    if (run.effect == kNotYet || run.end != kNotYet) continue;
    const bool has_reacted =
        std::any_of(run.reactions.begin(), run.reactions.end(),
                    [&](const MalfunctionRun::Reaction& reaction) { return reaction.trainee == trainee; });
    if (has_reacted) continue;
    run.reactions.push_back({trainee, time});
    ++version_;
  }
}

void MalfunctionRuns::set_back(Time after) {
  ++version_;
  instant_ended();
  for (const Waiting& waiting : std::exchange(waiting_, {})) count(waiting, false);
  for (std::uint32_t unit = 0; unit < units_.size(); ++unit) {
    units_[unit] = static_cast<std::uint32_t>(trace::pack_unit(history_.unit(unit)));
  }
  std::erase_if(runs_, [&](const MalfunctionRun& run) { return run.start > after; });
  const auto& active = history_.malfunctions();
  for (MalfunctionRun& run : runs_) {
    std::erase_if(run.reactions, [&](const MalfunctionRun::Reaction& reaction) { return reaction.at > after; });
    if (run.effect > after) run.effect = kNotYet;
    const bool is_active = std::any_of(active.begin(), active.end(), [&](const trace::History::Malfunction& one) {
      return one.number == run.malfunction && one.since == run.start;
    });
    if (is_active) {
      run.end = kNotYet;
    } else if (run.end == kNotYet || run.end > after) {
      run.end = after;
    }
    if (run.end == kNotYet && run.effect == kNotYet) watch(waiting_for(run));
  }
  for (const trace::History::Malfunction& one : active) {
    const bool is_known = std::any_of(runs_.begin(), runs_.end(), [&](const MalfunctionRun& run) {
      return run.malfunction == one.number && run.start == one.since;
    });
    if (is_known) continue;
    runs_.push_back({next_++, one.number, one.since, kNotYet, kNotYet, {}});
    watch(waiting_for(runs_.back()));
    if (runs_.size() > kMostRuns) forget_oldest();
  }
  look(after, [&](const Waiting& waiting) { return acts_now(waiting); });
  affected_.clear();
}

}  // namespace symplant::panel
