// The plant: its external inputs, its instants in time.
#include "support/reference/reference.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "support/reference/difference.hpp"
#include "support/reference/findings.hpp"
#include "support/reference/hash.hpp"
#include "support/reference/malfunctions.hpp"
#include "support/reference/material.hpp"
#include "support/reference/start.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

/// Advances time: not for disabled or frozen units, and not for a stopped move. The instant that becomes due
/// is still to run.
void pass(World& world, Time time) {
  const Time gone = time - world.time;
  world.time = time;
  for (UnitWorld& unit : world.units) {
    if (unit.disabled || unit.frozen) continue;
    if (unit.moving && !unit.stopped_midway && unit.remaining != tables::kNever) unit.remaining -= gone;
    for (TransitionWorld& transition : unit.transitions) {
      if (transition.left == 0 || transition.left == tables::kNever) continue;
      transition.left -= gone;
      if (transition.left == 0) world.instant_pending = true;
    }
    if (unit.until_woken >= 0) unit.until_woken -= gone;
  }
}

void run_instant(const Rules& rules, World& world, bool sample, Counters& counters,
                 std::vector<InstantRecord>& instants) {
  const bool first = world.last_instant < 0;
  InstantNotes notes = empty_notes(rules);
  const std::vector<engine::MalfunctionChange> changes = begin_instant_of_malfunctions(rules, world, counters, notes);
  world.instant_pending = false;
  if (sample) {
    world.written_pending = false;
    for (std::uint32_t i = 0; i < world.symbols.size(); ++i) {
      if (rules.is_operation(i)) world.symbols[i].value = world.symbols[i].written;
    }
  }
  begin_instant_of_parts(rules, world, counters, notes);
  // Nothing is due in further instants of the same time.
  compute_values(rules, world, counters);
  write_signals(rules, world, counters);
  world.last_instant = world.time;
  run_rounds(rules, world, counters, notes);
  InstantRecord record;
  record.parts = world.material.by_hand;
  record.parts.insert(record.parts.end(), notes.parts.begin(), notes.parts.end());
  record.malfunctions = world.malfunctions.by_hand;
  record.malfunctions.insert(record.malfunctions.end(), changes.begin(), changes.end());
  world.malfunctions.by_hand.clear();
  record.time = world.time;
  record.findings = findings_of(rules, world, notes, counters);
  for (std::uint32_t i = 0; i < world.symbols.size(); ++i) {
    SymbolWorld& symbol = world.symbols[i];
    // The first instant reports the bits that are on.
    const std::uint64_t before = first && rules.is_bool(i) ? 0 : symbol.shown;
    if (effective(symbol) != before) record.changes.emplace_back(i, effective(symbol));
    symbol.shown = effective(symbol);
  }
  for (UnitWorld& unit : world.units) {
    unit.shown_settled = unit.moving ? tables::kNoState : unit.state;
    unit.shown_moving = unit.moving;
  }
  end_instant_of_parts(rules, world, counters);
  world.shown_material = world.material;
  record.values = traced_values(rules, world);
  end_instant_of_values(world);
  end_instant_of_malfunctions(rules, world, counters);
  const bool silent = record.changes.empty() && record.findings.empty() && record.parts.empty() &&
                      record.malfunctions.empty() && record.values.empty();
  if (!silent) instants.push_back(std::move(record));
}

/// The world as the last instant left it, for conditions and operations.
World as_shown(World world) {
  for (SymbolWorld& symbol : world.symbols) {
    symbol.value = symbol.shown;
    symbol.forced = false;
    symbol.broken = {};
  }
  for (UnitWorld& unit : world.units) {
    unit.state = unit.shown_settled;
    unit.moving = unit.shown_moving;
  }
  world.material = world.shown_material;
  for (ValueWorld& value : world.values) value.outputs = value.shown;
  return world;
}

std::uint64_t as_type(const Rules& rules, std::uint32_t symbol, std::uint64_t value) {
  return rules.is_bool(symbol) && value != 0 ? 1 : value;
}

}  // namespace

// A manual move is a leaving and an entering like any other: user code is called for both. It sees conditions and
// operations as the last instant left them.
void put_into_state(const Rules& rules, World& world, std::uint32_t index, std::uint8_t state, Counters& counters) {
  const World old = as_shown(world);
  InstantNotes notes = empty_notes(rules);
  Round round{rules, old, world, counters, notes};
  UnitWorld& unit = world.units[index];
  if (unit.moving) ++counters[Counted::set_state_moving];
  if (unit.disabled) ++counters[Counted::set_state_disabled];
  if (unit.frozen) ++counters[Counted::set_state_frozen];
  end_holds(unit);
  if (!unit.moving) leave(round, index, unit.state);
  unit.state = unit.target = state;
  unit.moving = unit.stopped_midway = unit.stopped_by_while = unit.returning = unit.automatic = false;
  unit.moving_now = kNoTransition;
  unit.remaining = unit.whole = 0;
  enter(round, index, state);
  world.instant_pending = true;
}

Plant::Plant(const model::PlantModel& model, std::map<std::string, Behaviour> behaviours)
    : model_(model), rules_(std::make_unique<Rules>(derive(model, std::move(behaviours)))) {
  reset();
}

Plant::~Plant() = default;

std::string Plant::difference_from_model() const { return difference(*rules_); }

void Plant::reset(std::uint64_t seed, Time cycle) {
  world_ = first_world(*rules_);
  world_.seed = seed;
  world_.cycle = cycle;
  cycle_ended_ = -1;
  reset_malfunctions(*rules_, world_);
  const World old = as_shown(world_);
  InstantNotes notes = empty_notes(*rules_);
  Round round{*rules_, old, world_, counters, notes};
  for (std::uint32_t i = 0; i < rules_->units.size(); ++i) {
    const Behaviour* behaviour = rules_->units[i].behaviour;
    if (behaviour == nullptr || behaviour->started == nullptr) continue;
    ++counters[Counted::started];
    View view(round, i);
    behaviour->started(view);
  }
  instants_.clear();
}

void Plant::end_cycle() {
  if (cycle_ended_ == world_.time) {
    for (SymbolWorld& symbol : world_.symbols) symbol.rose = SymbolWorld().rose;
  }
  cycle_ended_ = world_.time;
}

void Plant::set_operation(std::uint32_t symbol, std::uint64_t value) {
  for (const std::uint32_t each : rules_->together(symbol)) {
    world_.symbols[each].written = as_type(*rules_, symbol, value);
  }
  world_.written_pending = true;
}

bool Plant::set_input(std::uint32_t symbol, std::uint64_t value) {
  if (rules_->is_operation(symbol) || rules_->moved(symbol)) return false;
  if (rules_->inverted[symbol] && model_.symbols[symbol].unit == model::kNone) ++counters[Counted::inverted_input];
  for (const std::uint32_t each : rules_->together(symbol)) {
    world_.symbols[each].value = as_type(*rules_, symbol, value);
  }
  world_.instant_pending = true;
  return true;
}

void Plant::force(std::uint32_t symbol, std::uint64_t value) {
  if (rules_->inverted[symbol]) ++counters[Counted::inverted_forced];
  for (const std::uint32_t each : rules_->together(symbol)) {
    world_.symbols[each].forced = true;
    world_.symbols[each].forced_value = as_type(*rules_, symbol, value);
  }
  world_.instant_pending = true;
}

void Plant::release(std::uint32_t symbol) {
  for (const std::uint32_t each : rules_->together(symbol)) world_.symbols[each].forced = false;
  world_.instant_pending = true;
}

bool Plant::is_forced(std::uint32_t symbol) const { return world_.symbols[symbol].forced; }

void Plant::set_state(std::uint32_t unit, std::uint8_t state) {
  put_into_state(*rules_, world_, unit, state, counters);
}

bool Plant::start_malfunction(std::uint32_t number, engine::MalfunctionChange::By by) {
  constexpr std::size_t kMostOrdinary = 64;
  if (!malfunction_exists(*rules_, number)) return false;
  const std::size_t written = model_.malfunctions.size();
  const auto ordinary = std::count_if(world_.malfunctions.active.begin(), world_.malfunctions.active.end(),
                                      [&](const ActiveWorld& one) { return one.number >= written; });
  if (number >= written && !is_active(world_, number) && static_cast<std::size_t>(ordinary) == kMostOrdinary) {
    ++counters[Counted::start_refused];
    return false;
  }
  reference::start_malfunction(*rules_, world_, number, by, counters, world_.malfunctions.by_hand);
  return true;
}

bool Plant::stop_malfunction(std::uint32_t number, engine::MalfunctionChange::By by) {
  if (!malfunction_exists(*rules_, number)) return false;
  end_malfunction(*rules_, world_, number, by, counters, world_.malfunctions.by_hand);
  return true;
}

bool Plant::set_value(const std::string& name, double number) {
  return reference::set_value(*rules_, world_, find_value(*rules_, name), number, counters);
}

void Plant::set_quality(bool well) {
  world_.instant_pending = world_.instant_pending || world_.link_well != well;
  world_.link_well = well;
}

void Plant::advance_before(Time time) {
  for (Time due = next_due(); due < time; due = next_due()) {
    pass(world_, due);
    run_instant(*rules_, world_, false, counters, instants_);
  }
  if (time > world_.time) pass(world_, time);
}

void Plant::advance_to(Time time, std::vector<World>* ends) {
  const Time to = std::max(time, world_.time);
  advance_before(to);
  const auto instant = [&](bool sample) {
    run_instant(*rules_, world_, sample, counters, instants_);
    if (ends != nullptr) ends->push_back(world_);
  };
  if (world_.written_pending || next_due() <= to) instant(true);
  while (world_.malfunctions.pending) {
    ++counters[Counted::further_instant];
    instant(false);
  }
}

Time Plant::now() const { return world_.time; }

Time Plant::next_due(bool steps) const {
  if (world_.instant_pending) return world_.time;
  Time due = std::max(world_.time, next_due_of_parts(world_.material));
  due = std::min(due, std::max(world_.time, next_due_of_malfunctions(world_)));
  due = std::min(due, next_due_of_values(*rules_, world_, steps));
  for (const UnitWorld& unit : world_.units) {
    if (unit.disabled || unit.frozen) continue;
    if (unit.moving && !unit.stopped_midway) due = std::min(due, later(world_.time, unit.remaining));
    for (const TransitionWorld& transition : unit.transitions) {
      if (transition.holds && transition.left > 0) due = std::min(due, later(world_.time, transition.left));
    }
    if (unit.until_woken >= 0) due = std::min(due, later(world_.time, unit.until_woken));
  }
  for (std::size_t i = 0; i < world_.units.size(); ++i) {
    for (const OperationWorld& operation : world_.units[i].operations) {
      if (operation.at_end_since < 0) continue;
      const Time overruns = later(operation.at_end_since, rules_->units[i].overrun);
      if (overruns > world_.last_instant) due = std::min(due, std::max(world_.time, overruns));
    }
  }
  for (const MonitorWorld& monitor : world_.monitors) {
    if (monitor.running) due = std::min(due, std::max(world_.time, monitor.deadline));
  }
  return due;
}

const std::vector<InstantRecord>& Plant::instants() const { return instants_; }
void Plant::clear_instants() { instants_.clear(); }

std::uint64_t Plant::value(std::uint32_t symbol) const { return effective(world_.symbols[symbol]); }

UnitView Plant::unit(std::uint32_t index) const {
  const UnitWorld& unit = world_.units[index];
  return {unit.state, unit.target, unit.moving, unit.stopped_midway, unit.disabled, unit.frozen, unit.remaining};
}

double Plant::value_output(const std::string& name) const {
  for (std::size_t i = 0; i < rules_->values.size(); ++i) {
    for (std::uint32_t output = 0; output < rules_->values[i].outputs; ++output) {
      if (same_name(rules_->values[i].output_name(output), name)) return world_.values[i].outputs[output];
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool Plant::is_value_frozen(const std::string& name) const {
  const std::uint32_t value = find_value(*rules_, name);
  return value != kNone && world_.values[value].frozen;
}

bool Plant::disarmed(std::uint32_t symbol) const {
  const std::uint32_t owner = model_.symbols[symbol].unit;
  if (owner == model::kNone || !rules_->is_operation(symbol) || !is_on(*rules_, world_, symbol)) return false;
  const std::vector<std::uint32_t>& operations = rules_->units[owner].operations;
  const auto index = std::find(operations.begin(), operations.end(), symbol) - operations.begin();
  return !world_.units[owner].operations[static_cast<std::size_t>(index)].armed;
}

bool Plant::is_stuck(std::uint32_t unit) const { return reference::is_stuck(*rules_, world_, unit); }

std::uint32_t Plant::malfunction_of_symbol(std::uint32_t symbol) const {
  std::uint32_t found = kNone;
  const std::vector<std::uint32_t> together = rules_->together(symbol);
  for (const ActiveWorld& one : world_.malfunctions.active) {
    if (overrides_one_of(*rules_, one.number, together)) found = one.number;
  }
  return found;
}

std::uint64_t Plant::state_hash() const { return reference::state_hash(*rules_, world_); }

const World& Plant::save() const { return world_; }

void Plant::restore(const World& world) {
  const Time cycle = world_.cycle;  // of this run, not of the one that was saved
  world_ = world;
  world_.cycle = cycle;
  cycle_ended_ = -1;
  world_.material.by_hand.clear();  // changes that no instant has reported are not part of a save
  world_.malfunctions.by_hand.clear();
  ++counters[Counted::restored];
}

}  // namespace symplant::reference
