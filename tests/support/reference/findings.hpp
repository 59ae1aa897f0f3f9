// The findings of the plant at the end of an instant.
#pragma once

#include <vector>

#include "support/reference/round.hpp"
#include "symplant/tables/finding.hpp"

namespace symplant::reference {

/// Updates the memory of findings and monitors to the end of an instant; returns the findings in their order.
/// SymbolWorld::shown must still be that of the previous instant.
std::vector<tables::Finding> findings_of(const Rules& rules, World& world, const InstantNotes& notes,
                                         Counters& counters);

}  // namespace symplant::reference
