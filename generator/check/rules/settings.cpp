// Rules: the section `check` of plant.json, and the baseline.
#include "check/rules.hpp"

namespace symplant::check {

const Rule kIgnoreWithoutFinding{
    {"SP620", "ignore-without-finding", diag::Severity::warning, "an entry of `ignore` matches no finding",
     R"(An entry of `"check": { "ignore": [ ... ] }` in plant.json matches no finding. What it hid is fixed, or its pattern has a slip.

**What the model loses.** Nothing. But an entry that hides nothing today may hide a fault tomorrow.

**How to fix it.** Remove the entry, or correct its pattern. The pattern is compared with the name of the symbol, device (by its
path) or requirement that a finding is about. `*` matches any text, `?` one character.
)"},
    nullptr};

const Rule kIgnoreIsOver{
    {"SP621", "ignore-is-over", diag::Severity::warning, "an entry of `ignore` is past its date",
     R"(An entry of `"check": { "ignore": [ ... ] }` in plant.json has an `until`, the last day on which it counts, and that day is
over. The findings that it hid are reported again.

**What the model loses.** The entry costs nothing; see the findings that are reported again.

**How to fix it.** Fix the findings and remove the entry, or set a new date.
)"},
    nullptr};

const Rule kUnknownRule{
    {"SP622", "unknown-rule", diag::Severity::error, "the section `check` names an unknown rule",
     R"(The section `check` of plant.json names an unknown rule. Rules have an id (`SP402`) and a slug (`event-without-operation`);
`symplant rules` lists them.

**What the model loses.** The entry has no effect: its findings are reported as if it were not there.

**How to fix it.** Correct the name; the message gives the nearest one.
)"},
    nullptr};

const Rule kBindingRule{
    {"SP623", "binding-rule", diag::Severity::error, "the section `check` lowers or ignores an error that cannot be",
     R"(The section `check` of plant.json lowers or ignores a rule whose findings are errors. After such an error there is no valid
plant: a file could not be read, two devices drive one event, the description contradicts itself. Two errors may be lowered or
ignored: `symbol-declared-differently` (SP302), since the first of two rows counts, and `no-device` (SP415), since the symbols
remain.

**What the model loses.** The entry has no effect.

**How to fix it.** Fix the errors, and remove the entry.
)"},
    nullptr};

const Rule kDateNotUnderstood{
    {"SP624", "date-not-understood", diag::Severity::error, "the `until` of an entry of `ignore` is not a date",
     R"(The `until` of an entry of `"check": { "ignore": [ ... ] }` in plant.json is not a date of the calendar in the form
`2027-06-30`: year, month, day.

**What the model loses.** The entry has no effect, and the findings that it should hide are reported.

**How to fix it.** Correct the date, or remove `until` if the entry has no end.
)"},
    nullptr};

const Rule kRuleRenamed{
    {"SP625", "rule-renamed", diag::Severity::warning, "the section `check` uses the former name of a rule",
     R"(The section `check` of plant.json names a rule by a slug of an earlier version, such as `nobody-moves` for
`event-not-driven`.

**What the model loses.** Nothing in this version: the entry counts as if it had the new name. The next version rejects it.

**How to fix it.** Write the name that the message gives, or the rule's id, which never changes.
)"},
    nullptr};

const Rule kBaselineStale{
    {"SP626", "baseline-stale", diag::Severity::warning, "a baseline has findings that are no longer there",
     R"(The file of `--baseline` has findings that the plant no longer has: they are fixed. The other findings of the file still count.

**What the model loses.** Nothing. But an entry that hides nothing today may hide a fault tomorrow.

**How to fix it.** Run the same command with `--write-baseline` instead of `--baseline`: the file keeps what is still found.
)"},
    nullptr};

const Rule kBaselineNotValid{
    {"SP627", "baseline-not-valid", diag::Severity::error, "the file of `--baseline` is not a baseline",
     R"(The file of `--baseline` or `--write-baseline` is not a baseline: it is not valid JSON, or it has other keys or values.

**What the model loses.** Nothing is checked, so that no finding is hidden by mistake.

**How to fix it.** Restore the file from version control, or delete it and write it again: `symplant check PLANT
--write-baseline FILE`.
)"},
    nullptr};

}  // namespace symplant::check
