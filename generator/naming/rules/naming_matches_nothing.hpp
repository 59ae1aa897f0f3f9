// SP618: a part of a naming rule matches nothing.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::naming {

inline constexpr diag::RuleInfo kNamingMatchesNothing{
    .id = "SP618",
    .slug = "naming-matches-nothing",
    .severity = diag::Severity::warning,
    .summary = "a part of a naming rule matches nothing",
    .page =
        R"page(A rule of naming.json reads no symbol, or an archetype finds no device with texts for its roles. Rules apply in their order: an
earlier rule may take all symbols that this one is made for. Ready profiles are not reported, since no list has all their forms.

**What the model loses.** Nothing, if the entry is left over. Otherwise the symbols that it is made for are read by another rule or not
paired.

**How to fix it.** Correct the pattern or the texts, move the rule before the one that takes its symbols, or remove it. `symplant infer`
shows the texts of the list by shape.
)page"};

}  // namespace symplant::naming
