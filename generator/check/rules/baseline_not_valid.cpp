// SP627 baseline-not-valid: the file of --baseline is not one.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kBaselineNotValidPage =
    R"(The file of `--baseline` or `--write-baseline` is not a baseline: it is not valid JSON, or it has other keys or values.

**What the model loses.** Nothing is checked, so that no finding is hidden by mistake.

**How to fix it.** Restore the file from version control, or delete it and write it again: `symplant check PLANT
--write-baseline FILE`.
)";

}  // namespace

const Rule kBaselineNotValid{{"SP627", "baseline-not-valid", diag::Severity::error,
                              "the file of `--baseline` is not a baseline", kBaselineNotValidPage},
                             nullptr};

}  // namespace symplant::check
