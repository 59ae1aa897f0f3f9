// Groups symbols into units: each device, or the facets that the naming rule makes of it.
#pragma once

#include <vector>

#include "model/derived.hpp"
#include "name/reading.hpp"

namespace symplant::model {

/// Makes the units of a plant in the order of their first symbol, and says why the other symbols are in none.
/// `readings` are those of the symbols, empty if each device is one unit. Constants get their value as initial value.
/// O(symbols).
void group_symbols(Derived& derived, const std::vector<const name::Reading*>& readings);

}  // namespace symplant::model
