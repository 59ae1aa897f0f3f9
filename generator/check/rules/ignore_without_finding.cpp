// SP620 ignore-without-finding: an entry hides nothing.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kIgnoreWithoutFindingPage =
    R"(An entry of `"check": { "ignore": [ ... ] }` in plant.json matches no finding. What it hid is fixed, or its pattern has a slip.

**What the model loses.** Nothing. But an entry that hides nothing today may hide a fault tomorrow.

**How to fix it.** Remove the entry, or correct its pattern. The pattern is compared with the name of the symbol, device (by its
path) or requirement that a finding is about. `*` matches any text, `?` one character.
)";

}  // namespace

const Rule kIgnoreWithoutFinding{{"SP620", "ignore-without-finding", diag::Severity::warning,
                                  "an entry of `ignore` matches no finding", kIgnoreWithoutFindingPage},
                                 nullptr};

}  // namespace symplant::check
