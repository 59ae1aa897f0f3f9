// Behaviours for random plants: each written once, for engine and reference alike.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "support/reference/behaviour.hpp"
#include "symplant/core/behaviour.hpp"
#include "symplant/core/tables.hpp"

namespace symplant::property {

// What a unit must have for any of the behaviours.
inline constexpr std::size_t kLeastOperations = 1;
inline constexpr std::size_t kLeastEvents = 1;
inline constexpr std::size_t kLeastValues = 2;
inline constexpr std::size_t kLeastStates = 2;
inline constexpr std::size_t kLeastInputs = 1;

const std::vector<std::string>& behaviour_names();
/// One of these, perhaps with `_` and something behind it: `Counting`, `Counting_3`.
bool is_behaviour(std::string_view name);

/// For core::Plant, by the place of their names in the tables.
std::vector<core::Behaviour> engine_behaviours(const core::PlantTables& tables);
std::map<std::string, reference::Behaviour> reference_behaviours(const core::PlantTables& tables);

}  // namespace symplant::property
