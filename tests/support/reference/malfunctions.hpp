// Malfunctions in the reference (docs/malfunctions.md).
#pragma once

#include <cstdint>
#include <vector>

#include "support/reference/round.hpp"

namespace symplant::reference {

/// Whether there is a malfunction of this number: the written ones, then two of each unit, then two of each symbol.
bool malfunction_exists(const Rules& rules, std::uint32_t number);
/// What a malfunction does; an ordinary one as if it were written.
std::vector<model::Effect> effects_of(const Rules& rules, std::uint32_t number);
inline bool is_written(const Rules& rules, std::uint32_t number) { return number < rules.model->malfunctions.size(); }
bool names_unit(const model::Effect& effect, std::uint32_t unit);

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
/// Works out what the active ones make of each symbol, and of each parameter.
void override_symbols(const Rules& rules, World& world);
/// An effect begins to act on units.
void count_units(const model::Effect& effect, const World& world, Counters& counters);
/// Begins effect `index` of a written malfunction that starts.
void begin_effect(const Rules& rules, World& world, std::uint32_t number, std::size_t index, Counters& counters);
/// The speed of a drive of a track that would be `speed` without malfunctions.
std::int64_t slowed_drive(const Rules& rules, const World& world, std::uint32_t track, std::int64_t speed);
/// The number of a signal that would be `number` without malfunctions.
double distorted(const Rules& rules, const World& world, std::uint32_t symbol, double number, Counters& counters);

/// As moved by hand: at once, between two instants (reference.cpp).
void put_into_state(const Rules& rules, World& world, std::uint32_t unit, std::uint8_t state, Counters& counters);

}  // namespace symplant::reference
