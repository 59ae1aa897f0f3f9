// What active malfunctions add to explanations.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/explanation.hpp"

namespace symplant::why {

/// The active malfunctions in the order in which they started.
using ActiveMalfunctions = std::span<const trace::History::Malfunction>;

/// "malfunction `jam`, malfunction `rust`": those that disable a unit; empty if there are none. This function and the
/// next are O(active malfunctions * log of the units of one).
std::string disabling_malfunctions(std::uint32_t unit, const trace::PlantNames& names, ActiveMalfunctions active);

/// ", slowed by malfunction `old grease`"; empty if none slows a unit.
std::string slowing_malfunctions(std::uint32_t unit, const trace::PlantNames& names, ActiveMalfunctions active);

/// ", forced by malfunction `wire`": the one that started last of those that override a symbol; empty if there is none.
/// O(active malfunctions * symbols of one).
std::string overriding_malfunction(std::uint32_t symbol, const trace::PlantNames& names, ActiveMalfunctions active);

/// Adds a cause for each active malfunction that the explanation does not name.
void add_malfunctions(Explanation& explanation, const trace::PlantNames& names, ActiveMalfunctions active);

}  // namespace symplant::why
