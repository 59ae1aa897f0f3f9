// Proposes values and signals for a list: numbers for the numeric inputs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// `values` and `signals` for numeric inputs that nothing drives, one of those whose names differ in numbers only; what
/// a value is follows from words of its name. Null without one, or if the plant has values. `left_out` is how
/// many such inputs have no entry. O(symbols).
nlohmann::ordered_json proposed_values(const model::PlantModel& plant, std::size_t& left_out);

}  // namespace symplant::emit
