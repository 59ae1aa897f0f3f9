// SP626 baseline-stale: a baseline has findings that are no longer there.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kBaselineStalePage =
    R"(The file of `--baseline` has findings that the plant no longer has: they are fixed. The other findings of the file still count.

**What the model loses.** Nothing. But an entry that hides nothing today may hide a fault tomorrow.

**How to fix it.** Run the same command with `--write-baseline` instead of `--baseline`: the file keeps what is still found.
)";

}  // namespace

const Rule kBaselineStale{{"SP626", "baseline-stale", diag::Severity::warning,
                           "a baseline has findings that are no longer there", kBaselineStalePage},
                          nullptr};

}  // namespace symplant::check
