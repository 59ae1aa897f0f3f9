// Behaviors for random plants: each written once, for engine and reference.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "support/reference/behaviour.hpp"
#include "symplant/engine/behaviour.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::property {

// What a unit must have for any of the behaviors.
inline constexpr std::size_t kLeastOperations = 1;
inline constexpr std::size_t kLeastEvents = 1;
inline constexpr std::size_t kLeastValues = 2;
inline constexpr std::size_t kLeastStates = 2;
inline constexpr std::size_t kLeastInputs = 1;

const std::vector<std::string>& behaviour_names();
/// One of these names, optionally followed by `_` and a suffix: `Counting`, `Counting_3`.
bool is_behaviour(std::string_view name);

/// For plant::Plant, by the index of their names in the tables.
std::vector<engine::Behaviour> engine_behaviours(const tables::PlantTables& tables);
std::map<std::string, reference::Behaviour> reference_behaviours(const tables::PlantTables& tables);

}  // namespace symplant::property
