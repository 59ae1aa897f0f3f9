// SP625 rule-renamed: the section `check` uses the former name of a rule.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kRuleRenamedPage =
    R"(The section `check` of plant.json names a rule by a slug of an earlier version, such as `nobody-moves` for
`event-not-driven`.

**What the model loses.** Nothing in this version: the entry counts as if it had the new name. The next version rejects it.

**How to fix it.** Write the name that the message gives, or the rule's id, which never changes.
)";

}  // namespace

const Rule kRuleRenamed{{"SP625", "rule-renamed", diag::Severity::warning,
                         "the section `check` uses the former name of a rule", kRuleRenamedPage},
                        nullptr};

}  // namespace symplant::check
