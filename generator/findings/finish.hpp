// The findings as the user sees them.
#pragma once

#include <string_view>

#include "description/description.hpp"
#include "diag/diagnostic.hpp"
#include "findings/selection.hpp"

namespace symplant::findings {

/// Folds the findings, applies the section `check` of plant.json and then the selection to the causes and what follows
/// from each, makes related rows of the consequences, and joins alike findings. Folding comes first, so that an ignored
/// finding takes what follows from it along. O(findings * entries).
diag::Diagnostics finish(diag::Diagnostics findings, const description::GivenCheck& settings, std::string_view today,
                         const Selection& selection);

}  // namespace symplant::findings
