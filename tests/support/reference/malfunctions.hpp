// Malfunctions in the reference (docs/malfunctions.md).
#pragma once

#include <cstdint>
#include <vector>

#include "support/reference/round.hpp"

namespace symplant::reference {

/// A malfunction of the model, or an ordinary one of a unit or symbol.
struct MalfunctionRules {
  tables::MalfunctionKind kind{};
  const model::Malfunction* written = nullptr;
  std::uint32_t of = kNone;  ///< of an ordinary one: a unit or a symbol
  bool on = false;           ///< of an ordinary one of a symbol

  bool names_unit(std::uint32_t unit) const;
};

/// Whether there is a malfunction of this number, and what it is: the written ones, then two of each unit, then two of
/// each symbol.
bool malfunction_exists(const Rules& rules, std::uint32_t number);
MalfunctionRules malfunction_of(const Rules& rules, std::uint32_t number);

// Changes (malfunctions.cpp). By hand or by a scenario they come before an instant.
void reset_malfunctions(const Rules& rules, World& world);
bool is_active(const World& world, std::uint32_t number);
void start_malfunction(const Rules& rules, World& world, std::uint32_t number, engine::MalfunctionChange::By by,
                       Counters& counters, std::vector<engine::MalfunctionChange>& changes);
void end_malfunction(const Rules& rules, World& world, std::uint32_t number, engine::MalfunctionChange::By by,
                     Counters& counters, std::vector<engine::MalfunctionChange>& changes);
/// Before the rounds of an instant: what is due by itself; then a loop of them is frozen.
std::vector<engine::MalfunctionChange> begin_instant_of_malfunctions(const Rules& rules, World& world,
                                                                     Counters& counters, InstantNotes& notes);
/// At the end of an instant: the conditions.
void end_instant_of_malfunctions(const Rules& rules, World& world, Counters& counters);
Time next_due_of_malfunctions(const World& world);

// What they do (malfunction_effects.cpp).
bool is_stuck(const Rules& rules, const World& world, std::uint32_t unit);
/// The travel time of a move that begins and takes `time` without malfunctions.
Time slowed(const Rules& rules, const World& world, std::uint32_t unit, Time time, Counters& counters);
/// Whether a malfunction gives one of the symbols a value or lets it flicker.
bool overrides_one_of(const Rules& rules, std::uint32_t number, const std::vector<std::uint32_t>& symbols);
/// Works out what the active ones make of each symbol.
void override_symbols(const Rules& rules, World& world);

/// As moved by hand: at once, between two instants (reference.cpp).
void put_into_state(const Rules& rules, World& world, std::uint32_t unit, std::uint8_t state, Counters& counters);

}  // namespace symplant::reference
