// SP620 ignore-without-finding: an entry hides nothing.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kIgnoreWithoutFindingPage =
    R"(An entry of `"check": { "ignore": [ ... ] }` in plant.json fits no finding. What it hid was mended, or its pattern has a slip.

**What the model loses.** Nothing. But an entry that hides nothing today may hide a fault tomorrow.

**How to fix it.** Take the entry out, or correct its pattern. A pattern is compared with the name of the symbol, device (by
its path) or requirement that a finding is about; `*` stands for any text, `?` for one character.
)";

}  // namespace

const Rule kIgnoreWithoutFinding{{"SP620", "ignore-without-finding", diag::Severity::warning,
                                  "an entry of `ignore` fits no finding", kIgnoreWithoutFindingPage},
                                 nullptr};

}  // namespace symplant::check
