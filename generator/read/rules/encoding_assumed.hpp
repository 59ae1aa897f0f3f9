// SP121: the code page of a list was recognized by few words.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kEncodingAssumed{
    .id = "SP121",
    .slug = "encoding-assumed",
    .severity = diag::Severity::warning,
    .summary = "the code page of a list was recognized by few words",
    .page =
        R"page(The list is not UTF-8 or UTF-16, and a file does not contain the name of its code page. It was recognized by the words
that are not ASCII, but there are fewer than five, and so few are sometimes recognized wrongly. The message shows the first one
as it was read, and as other code pages would read it.

**What the model loses.** Nothing if the word is correct in your language. Otherwise names and comments have wrong letters.

**How to fix it.** Give the encoding: `--encoding cp949`, or in plant.json `{ "file": "list.csv", "encoding": "cp949" }`. This also
removes the warning where the word is correct.
)page"};

}  // namespace symplant::read
