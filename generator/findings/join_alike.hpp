// Alike findings in devices of one type become one finding.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Joins findings of one rule and one Alike::kind into the first of them. Its message gets the number of the others and
/// three examples; each of the others becomes a related row, followed by its own related rows. The order stays. Comes
/// after the settings and the selection, which look at each finding, and after the folding. O(findings).
diag::Diagnostics join_alike(diag::Diagnostics findings);

}  // namespace symplant::findings
