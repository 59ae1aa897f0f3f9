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

/// Folds the findings, sifts and folds them again (what lost its cause may have another one), makes related rows of the
/// consequences, leaves out those of the baseline, and rolls up those of one shape.
diag::Diagnostics finish(diag::Diagnostics findings, const description::GivenCheck& settings, std::string_view today,
                         const Selection& selection, const Known& known = {});

/// Folds each finding into the one that explains it: one that names a subject in `explains` that the other names in
/// `follows`, and whose rule has a lower rank. Of several causes the one of the lowest rank counts, then the first. A
/// name that breaks the naming rule explains every missing symbol whose name is equal to it except for one level.
/// Nothing is lost: see Diagnostic::consequences. O(subjects).
void fold(diag::Diagnostics& diagnostics);

/// Applies the section `check` of plant.json and the selection: sets severities, moves ignored findings to
/// Diagnostics::ignored(), leaves out what is not selected and counts it, and adds the findings about the section
/// itself (SP620, SP622), whose locations are JSON pointers. The first entry of `ignore` that matches counts, whatever
/// is selected. `today` is YYYY-MM-DD; if it is empty, no entry is expired. What follows from an ignored finding goes
/// with it, unless it is more severe or binding; what follows from one that is not selected is reported separately if
/// it is selected. O(findings * entries).
diag::Diagnostics sift(const diag::Diagnostics& findings, const description::GivenCheck& settings,
                       std::string_view today, const Selection& selection);

/// Joins the findings of one rule and one Subjects::shape with a number into the first of them. Its message gets the
/// number of the others and three examples; each of the others becomes a related row, followed by its own related rows.
diag::Diagnostics roll_up(diag::Diagnostics findings);

}  // namespace symplant::findings
