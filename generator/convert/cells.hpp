// Cells of delimited text.
#pragma once

#include <string>
#include <string_view>

namespace symplant::convert {

/// Appends a cell, quoted if it has to be: with a comma, semicolon, TAB, quote, line end, or a blank at an end.
void append_cell(std::string& row, std::string_view text);

/// Like append_cell(), for files that people open in a spreadsheet. A text that a spreadsheet would take for a formula
/// gets an apostrophe before it; read::unprotected_cell() removes it. Numbers and lone signs stay as they are.
void append_protected_cell(std::string& row, std::string_view text);

}  // namespace symplant::convert
