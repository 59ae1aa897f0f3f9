// Collects the rows of all lists: symbols, internal rows, repeated names.
#pragma once

#include <vector>

#include "model/derived.hpp"
#include "model/list_input.hpp"

namespace symplant::model {

/// Fills in lists, controllers and symbols of a plant, and the evidence about other rows. O(rows).
void collect_symbols(Derived& derived, const std::vector<ListInput>& lists);

}  // namespace symplant::model
