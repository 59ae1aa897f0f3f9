// One cause, one finding: a finding that follows from another one becomes a consequence of it.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Folds each finding into the one that explains it: one that names a subject in `explains` that the other names in
/// `follows`, and whose rule has a lower rank. Of several causes the one of the lowest rank counts, then the first. A
/// name that breaks the naming rule explains every missing symbol whose name is equal to it except for one level.
/// Nothing is lost: see Diagnostic::consequences. O(subjects).
void fold(diag::Diagnostics& diagnostics);

}  // namespace symplant::findings
