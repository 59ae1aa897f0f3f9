// The findings as the user sees them.
#pragma once

#include <string>
#include <string_view>

#include "description/description.hpp"
#include "diag/diagnostic.hpp"
#include "findings/baseline.hpp"
#include "findings/selection.hpp"

namespace symplant::findings {

/// The baseline of a run, and the plant as the user wrote it. Null: every finding is reported.
struct Known {
  Baseline* baseline = nullptr;
  std::string plant = {};
};

/// Folds the findings, applies the section `check` of plant.json and then the selection to the causes and what follows
/// from each, makes related rows of the consequences, leaves out those of the baseline, and rolls up those of one
/// shape. Folding comes first, so that an ignored finding takes what follows from it along. O(findings * entries).
diag::Diagnostics finish(diag::Diagnostics findings, const description::GivenCheck& settings, std::string_view today,
                         const Selection& selection, const Known& known = {});

}  // namespace symplant::findings
