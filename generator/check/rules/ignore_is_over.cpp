// SP621 ignore-is-over: an entry is past its date.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kIgnoreIsOverPage =
    R"(An entry of `"check": { "ignore": [ ... ] }` in plant.json has an `until`, the last day on which it counts, and that day is
over. The findings that it hid are reported again.

**What the model loses.** The entry costs nothing; see the findings that are reported again.

**How to fix it.** Fix the findings and remove the entry, or set a new date.
)";

}  // namespace

const Rule kIgnoreIsOver{
    {"SP621", "ignore-is-over", diag::Severity::warning, "an entry of `ignore` is past its date", kIgnoreIsOverPage},
    nullptr};

}  // namespace symplant::check
