// SP622 unknown-rule: the settings name an unknown rule.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kUnknownRulePage =
    R"(The section `check` of plant.json names an unknown rule. Rules have an id (`SP402`) and a slug (`event-without-operation`);
`symplant rules` lists them.

**What the model loses.** The entry has no effect: its findings are reported as if it were not there.

**How to fix it.** Correct the name; the message gives the nearest one.
)";

}  // namespace

const Rule kUnknownRule{
    {"SP622", "unknown-rule", diag::Severity::error, "the section `check` names an unknown rule", kUnknownRulePage},
    nullptr};

}  // namespace symplant::check
