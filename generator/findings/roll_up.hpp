// Findings of one rule and one shape become one finding.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Joins the findings of one rule and one Subjects::shape with a number into the first of them. Its message gets the
/// number of the others and three examples; each of the others becomes a related row, followed by its own related rows.
/// The order stays. Comes after the settings and the selection, which look at each finding, and after the folding.
/// O(findings).
diag::Diagnostics roll_up(diag::Diagnostics findings);

}  // namespace symplant::findings
