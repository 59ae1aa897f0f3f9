// The section `check` of plant.json: which findings to ignore, and the severities of rules.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/description.hpp"
#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Whether a rule reports an error that makes a valid plant impossible: it is neither lowered nor ignored.
bool is_binding(const diag::RuleInfo& rule);

/// For a message: such a rule cannot be what the user wishes, for example "ignored".
std::string binding_text(const diag::RuleInfo& rule, std::string_view wish);

/// Takes from an ignored finding the consequences that are reported all the same: those that are more severe than it,
/// or binding. The others stay with it.
std::vector<diag::Diagnostic> take_independent(diag::Diagnostic& ignored);

/// Applies the section `check` of plant.json: sets severities, moves ignored findings to Diagnostics::ignored(), and
/// adds the findings about the section itself (SP620 to SP624), whose locations are JSON pointers. The first entry that
/// matches counts. `today` is YYYY-MM-DD; if it is empty, no entry is expired. The consequences of an ignored finding
/// go with it, except those of take_independent(). O(findings * entries).
diag::Diagnostics apply_settings(const diag::Diagnostics& findings, const description::GivenCheck& settings,
                                 std::string_view today);

}  // namespace symplant::findings
