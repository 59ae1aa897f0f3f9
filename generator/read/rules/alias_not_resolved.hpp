// SP115: an alias of a Logix tag leads to no tag.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kAliasNotResolved{
    .id = "SP115",
    .slug = "alias-not-resolved",
    .severity = diag::Severity::warning,
    .summary = "an alias leads to no tag",
    .page =
        R"page(An alias of a Logix tag names another tag, which may be an alias too. Following them must end at a tag of a module
(`Local:1:I.Data.0`) or of the controller. Here an alias leads back to itself, its target is not in the export, or the
operand becomes longer than 255 characters. Tags of modules may be missing from an export: they are known by their colons.

**What the model loses.** The row is counted as memory, so the signal is neither an input nor an output.

**How to fix it.** Correct the alias in the project and export it again, or export the tags of all programs together
with those of the controller.
)page",
    .rank = diag::Rank::address};

}  // namespace symplant::read
