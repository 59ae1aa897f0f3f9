// SP623 binding-rule: an error is lowered that cannot be.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kBindingRulePage =
    R"(The section `check` of plant.json lowers or ignores a rule whose findings are errors. After such an error there is no valid
plant: a file could not be read, two devices drive one event, the description contradicts itself. Two errors may be lowered or
ignored: `symbol-declared-differently` (SP302), since the first of two rows counts, and `no-device` (SP415), since the symbols
remain.

**What the model loses.** The entry has no effect.

**How to fix it.** Fix the errors, and remove the entry.
)";

}  // namespace

const Rule kBindingRule{{"SP623", "binding-rule", diag::Severity::error,
                         "the section `check` lowers or ignores an error that cannot be", kBindingRulePage},
                        nullptr};

}  // namespace symplant::check
