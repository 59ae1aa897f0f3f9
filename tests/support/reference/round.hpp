// A round of an instant: reads the old world, writes the next.
#pragma once

#include <cstdint>
#include <vector>

#include "support/reference/counters.hpp"
#include "support/reference/rules.hpp"
#include "support/reference/world.hpp"

namespace symplant::reference {

/// What one unit's step found about its operations.
struct Look {
  bool conflicting = false;  ///< several states wanted, or a move with both directions
  bool neither = false;      ///< a commanded move with neither direction
};

/// What the findings of an instant need from its rounds. Not part of the world.
struct InstantNotes {
  /// A unit, then the symbols that follow, tracks, transfers, work, sources, malfunctions (never) and values: the
  /// rounds, counted since the last freeze, in which it stepped.
  std::vector<std::vector<int>> steps;
  std::vector<std::vector<bool>> served;  ///< a unit: its operations that fired a transition or reversed a move
  std::vector<bool> enabled;              ///< units
  std::vector<bool> event_changed;        ///< symbols: a round changed its effective level
  std::vector<Look> looks;                ///< units, in the last round
  /// What each freeze froze, as indexes of `steps`.
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<engine::PartChange> parts;  ///< in the order of the rounds
};

struct Round {
  const Rules& rules;
  const World& old;
  World& next;
  Counters& counters;
  InstantNotes& notes;

  const UnitRules& of(std::uint32_t unit) const { return rules.units[unit]; }
};

/// After forces, as a bit.
std::uint64_t effective(const SymbolWorld& symbol);
/// After forces, as a level.
bool is_on(const Rules& rules, const World& world, std::uint32_t symbol);

bool holds(const condition::Tree& tree, const World& world);

/// On and armed, in the snapshot.
bool operation_on(const Round& round, std::uint32_t unit, std::uint32_t operation);
/// The transition's `when` holds in the snapshot, or it has none.
bool when_holds(const Round& round, std::uint32_t unit, const Transition& transition);

/// Draws or reads a transition's time; `way` may be kNoTransition: from `from` to `to` without a command.
Time takes_of(Round& round, std::uint32_t unit, std::uint16_t transition, std::uint8_t from, std::uint8_t to);
Time after_of(Round& round, std::uint32_t unit, std::uint16_t transition);
/// Whether a transition remembers that its cause holds.
bool remembers(const UnitRules& unit, const Transition& transition);

/// The first output of SplitMix64 started at draw `k` of stream `n` of a unit.
std::uint64_t first_output(std::uint64_t seed, const std::string& unit, std::uint64_t n, std::uint64_t k);

/// Draw `k` of transition number 0 of a name: (sum - 6 * 2^32) / 2^32, about normal with a standard deviation of 1.
double draw_gauss(std::uint64_t seed, const std::string& name, std::uint64_t k);

/// Draw `k` of a random time of transition number `n`.
Time draw_duration(std::uint64_t seed, const std::string& unit, std::uint64_t n, std::uint64_t k,
                   const description::Duration& duration);
Time later(Time now, Time left);

/// A draw for the weights of automatic transitions: uniform on [0, sum - 1], counted with a transition's draws.
std::uint64_t draw_weight(Round& round, std::uint32_t unit, std::uint16_t transition, std::uint64_t sum);

/// Brings an event to a level, and all symbols at its address to its bit.
void write_event(const Rules& rules, World& world, std::uint32_t symbol, std::uint64_t value);
void leave(Round& round, std::uint32_t unit, std::uint8_t state);
void enter(Round& round, std::uint32_t unit, std::uint8_t state);
void end_holds(UnitWorld& unit);

/// The unit's step. True if it made one.
bool step(Round& round, std::uint32_t unit);
/// Step 2 of docs/model.md: a moving unit, time remaining.
bool step_moving(Round& round, std::uint32_t unit);
/// The behavior's wanted state, or tables::kNoState.
std::uint8_t wanted_by_behaviour(Round& round, std::uint32_t unit);
/// The unit's first transition in that direction that is not automatic, or kNoTransition. A move without a command
/// takes its time from it, and obeys its `while`.
std::uint16_t first_not_automatic(const UnitRules& unit, std::uint8_t from, std::uint8_t to);
void serve(Round& round, std::uint32_t unit, std::uint32_t operation);

/// Determines which units are disabled. True if any unit became disabled or enabled.
bool work_out_disabled(const Rules& rules, World& world, Counters& counters, InstantNotes& notes);
/// Every symbol that follows a condition takes its truth in the snapshot. `number`: of the round. True if one changed.
bool follow_conditions(Round& round, int number);
/// All rounds of an instant, starting with the disables.
void run_rounds(const Rules& rules, World& world, Counters& counters, InstantNotes& notes);

}  // namespace symplant::reference
