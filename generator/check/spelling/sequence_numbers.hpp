// A device's numbered states, with their numbers as numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::check {

struct NumberedState {
  std::uint64_t number;
  std::uint32_t state;   ///< index in Unit::states
  std::uint32_t symbol;  ///< the first of its symbols in list order, index in PlantModel::symbols
};

/// Puts them into `states`, by number, those of one number by first row. Empty where a number has more than 18 digits.
/// States without a symbol do not count.
void numbered_states(const model::Unit& unit, std::vector<NumberedState>& states);

}  // namespace symplant::check
