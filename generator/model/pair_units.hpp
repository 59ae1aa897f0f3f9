// Groups symbols by the facets that a custom naming rule makes of them.
#pragma once

#include <vector>

#include "model/derived.hpp"
#include "name/rule_reading.hpp"

namespace symplant::model {

/// Makes the units of a plant and says why the other symbols are in none. `readings` are those of the symbols.
/// Constants get their value as initial value. O(symbols).
void pair_units(Derived& derived, const std::vector<const name::RuleReading*>& readings);

}  // namespace symplant::model
