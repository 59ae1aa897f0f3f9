// SP624 date-not-understood: a date of the settings is none.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDateNotUnderstoodPage =
    R"(The `until` of an entry of `"check": { "ignore": [ ... ] }` in plant.json is no date of the calendar in the form
`2027-06-30`: year, month, day.

**What the model loses.** The entry counts for nothing, and what it was to hide is told.

**How to fix it.** Correct the date, or leave `until` out where the entry is to count for ever.
)";

}  // namespace

const Rule kDateNotUnderstood{{"SP624", "date-not-understood", diag::Severity::error,
                               "the `until` of an entry of `ignore` is no date", kDateNotUnderstoodPage},
                              nullptr};

}  // namespace symplant::check
