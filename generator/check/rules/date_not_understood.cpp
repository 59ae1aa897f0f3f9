// SP624 date-not-understood: a date of the settings is invalid.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDateNotUnderstoodPage =
    R"(The `until` of an entry of `"check": { "ignore": [ ... ] }` in plant.json is not a date of the calendar in the form
`2027-06-30`: year, month, day.

**What the model loses.** The entry has no effect, and the findings that it should hide are reported.

**How to fix it.** Correct the date, or remove `until` if the entry has no end.
)";

}  // namespace

const Rule kDateNotUnderstood{{"SP624", "date-not-understood", diag::Severity::error,
                               "the `until` of an entry of `ignore` is not a date", kDateNotUnderstoodPage},
                              nullptr};

}  // namespace symplant::check
