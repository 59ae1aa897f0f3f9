// SP123: a workbook cannot be read.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnreadableWorkbook{
    .id = "SP123",
    .slug = "unreadable-workbook",
    .severity = diag::Severity::error,
    .summary = "a workbook or package cannot be read",
    .page =
        R"page(The file is a workbook (.xlsx) or an AutomationML package (.amlx), but it is damaged, encrypted, or too large: at most 1,000 parts,
128 MB of text, 2 GB unpacked, and 100 times its packed size. Or a workbook has several sheets with symbols, or not the sheet that was asked for. The message gives the reason.

**What the model loses.** It cannot be built, and nothing is written.

**How to fix it.** Open the workbook and save it again without a password, or save the sheet with the symbols as CSV. With several
sheets, name one: `--columns sheet=IO`, or in plant.json `{ "file": "io.xlsx", "columns": { "sheet": "IO" } }`.
)page"};

}  // namespace symplant::read
