// Collects the rows of all lists: symbols, internal rows, repeated names.
#pragma once

#include <vector>

#include "model/derived.hpp"
#include "model/list_input.hpp"

namespace symplant::model {

/// Fills in lists, controllers and symbols of a plant, and the evidence about other rows. If the naming rule makes
/// facets, returns the reading of each symbol, in `lists`. O(rows).
std::vector<const name::Reading*> collect_symbols(Derived& derived, const std::vector<ListInput>& lists);

}  // namespace symplant::model
