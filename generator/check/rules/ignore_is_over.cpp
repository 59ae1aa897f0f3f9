// SP621 ignore-is-over: an entry is past its date.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kIgnoreIsOverPage =
    R"(An entry of `"check": { "ignore": [ ... ] }` in plant.json has an `until`, the last day on which it counts, and that day is
over. The findings that it hid are told again.

**What the model loses.** Nothing by the entry; what the findings say, it loses still.

**How to fix it.** Mend what the findings say and take the entry out, or set a new date.
)";

}  // namespace

const Rule kIgnoreIsOver{
    {"SP621", "ignore-is-over", diag::Severity::warning, "an entry of `ignore` is past its date", kIgnoreIsOverPage},
    nullptr};

}  // namespace symplant::check
