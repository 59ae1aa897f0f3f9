// What the plant finds at the end of an instant.
#pragma once

#include <vector>

#include "support/reference/round.hpp"
#include "symplant/tables/finding.hpp"

namespace symplant::reference {

/// Brings the memory of findings and monitors up to date with the end of an instant; the findings, in their order.
/// SymbolWorld::shown must still be that of the instant before.
std::vector<tables::Finding> findings_of(const Rules& rules, World& world, const InstantNotes& notes,
                                         Counters& counters);

}  // namespace symplant::reference
