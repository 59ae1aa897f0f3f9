// What the user's plant description says of the findings themselves: which to leave out, which count more or less.
#pragma once

#include <string>
#include <string_view>

#include "description/description.hpp"
#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// True for the errors after which nothing sound is left to go on with: they are neither lowered nor ignored.
bool is_binding(const diag::RuleInfo& rule);

/// For a message: that such a rule cannot be what the user wishes, "ignored" say.
std::string binding_text(const diag::RuleInfo& rule, std::string_view wish);

/// The findings as the section `check` of plant.json wants them: levels set, what is ignored among
/// Diagnostics::ignored(), and what is wrong with the section itself added (SP620 to SP624). Of several entries the
/// first that fits counts. Places in the section are JSON pointers. `today` is YYYY-MM-DD; where it is empty no entry
/// is over. O(findings * entries).
diag::Diagnostics apply_settings(const diag::Diagnostics& findings, const description::GivenCheck& settings,
                                 std::string_view today);

}  // namespace symplant::findings
