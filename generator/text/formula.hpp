// Cells that a spreadsheet would take for formulas (CWE-1236), and their protection.
#pragma once

#include <string_view>

namespace symplant::text {

/// Whether a spreadsheet may run the text as a formula: it begins with `=`, `+`, `-`, `@` (also in full width), TAB or
/// a line end, and is neither a number nor only signs.
bool is_formula(std::string_view utf8);

/// Whether the text is a formula, or apostrophes followed by one. With an apostrophe before it, it is text for a
/// spreadsheet; unprotected() gives it back.
bool needs_protection(std::string_view utf8);

/// A cell without the apostrophe that protects it; any other cell as it is.
std::string_view unprotected(std::string_view cell);

}  // namespace symplant::text
