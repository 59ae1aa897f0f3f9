// Evaluates conditions and expectations of a scenario.
#pragma once

#include <cstdint>

#include "symplant/condition/tree.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/scenario/scenario.hpp"

namespace symplant::scenario {

/// The value of a symbol after forces, in the representation of its plane.
std::uint64_t value_of(const plant::Plant& plant, std::uint32_t symbol) noexcept;

/// The number of parts of a kind at a location, of all kinds with kNone. O(parts at the location).
std::uint64_t parts_at(const plant::Plant& plant, std::uint32_t location, std::uint32_t kind) noexcept;

/// REAL and LREAL compare as numbers, with NaN equal to NaN; all other types bit by bit.
bool equal_values(tables::DataType type, std::uint64_t a, std::uint64_t b) noexcept;

bool holds(const condition::Tree& tree, const plant::Plant& plant) noexcept;
bool holds(const Expectation& expectation, const plant::Plant& plant) noexcept;

}  // namespace symplant::scenario
