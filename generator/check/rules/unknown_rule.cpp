// SP622 unknown-rule: a rule of the settings is none.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kUnknownRulePage =
    R"(The section `check` of plant.json names a rule that there is not. A rule is named by its id (`SP402`) or its name
(`event-without-operation`); `symplant rules` lists them.

**What the model loses.** The entry counts for nothing, and what it was to hide or to raise is told as ever.

**How to fix it.** Correct the name; the message says the nearest.
)";

}  // namespace

const Rule kUnknownRule{
    {"SP622", "unknown-rule", diag::Severity::error, "the section `check` names a rule that is none", kUnknownRulePage},
    nullptr};

}  // namespace symplant::check
