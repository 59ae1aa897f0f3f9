// What a step does to a plant between two instants, for scenarios and for the operator at the panel.
#pragma once

#include "symplant/plant/plant.hpp"
#include "symplant/scenario/program_control.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::scenario {

/// The `of` of a note about a force: its value is twice the symbol's index, and 1 more if it is now forced.
inline constexpr std::uint32_t kForceNote = 0xFFFF'FFFE;

/// Whether a trace needs an act for the step: true if the step does more than set operations, which a trace records as
/// changes of symbols. O(actions).
bool needs_act(const Step& step, const tables::PlantTables& tables) noexcept;

/// The maximum number of changes of parts and malfunctions by a step. The engine reports at least engine::kMostByHand
/// of one instant. O(1).
std::size_t changes_by_hand(const Step& step) noexcept;

/// The first actions of a step: `restart`, `set`, then `state`. `programs` may be null: nothing restarts. For the
/// thread that runs the plant; O(actions).
void write_symbols(const Step& step, plant::Plant& plant, ProgramControl* programs) noexcept;

/// The last actions of a step: `force`, then `release`, with notes about them. For the same thread; O(actions).
void force_symbols(const Step& step, plant::Plant& plant, trace::Recorder& recorder) noexcept;

/// Releases a symbol that is forced, with a note.
void release(std::uint32_t symbol, plant::Plant& plant, trace::Recorder& recorder) noexcept;

}  // namespace symplant::scenario
