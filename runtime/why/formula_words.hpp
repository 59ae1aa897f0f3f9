// A formula with the numbers of what it reads.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "symplant/why/plant_index.hpp"
#include "symplant/why/state_view.hpp"

namespace symplant::why {

/// A number with about four digits that count; a whole one with all its digits.
std::string number_words(double number);

/// `2 * L_S1_PUMP.RUN (1) - outflow (0.02)`: the text of a formula, each name that it reads followed by its number
/// where the text first has it, if it is known. O(text + names * (conditions + symbols)).
std::string formula_words(std::uint32_t formula, std::string_view text, const PlantIndex& index, const StateView& view);

}  // namespace symplant::why
