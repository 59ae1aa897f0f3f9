// SP209 direction-conflict: a name and its address disagree under a naming rule that forbids it.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDirectionConflictPage =
    R"(The naming rule has `"direction": { "on-conflict": "error" }`, and the direction in a symbol's name contradicts its address.

**What the model loses.** Nothing is run or generated until all names and addresses agree.

**How to fix it.** Correct the name or the address. If the contradiction is wanted, such as an echo that is named from the
partner's side, remove `on-conflict`: then it is the warning `direction-against-address`.
)";

void check_direction_conflict(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  if (conflicts_are_errors(subject.plant)) report_direction_conflicts(rule, subject, diagnostics);
}

}  // namespace

const Rule kDirectionConflict{{"SP209", "direction-conflict", diag::Severity::error,
                               "a name and its address disagree under a naming rule that forbids it",
                               kDirectionConflictPage, diag::Rank::direction},
                              check_direction_conflict};

}  // namespace symplant::check
