// SP623 binding-rule: an error is lowered that cannot be.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kBindingRulePage =
    R"(The section `check` of plant.json lowers or ignores a rule whose findings are errors. After such an error there is no sound
plant: a file could not be read, two devices move one event, the description contradicts itself. `symbol-declared-differently`
(SP302) is the one error that may be lowered or ignored, since the first of two rows counts.

**What the model loses.** The entry counts for nothing.

**How to fix it.** Mend what the errors say, and take the entry out.
)";

}  // namespace

const Rule kBindingRule{{"SP623", "binding-rule", diag::Severity::error,
                         "the section `check` lowers or ignores an error that cannot be", kBindingRulePage},
                        nullptr};

}  // namespace symplant::check
