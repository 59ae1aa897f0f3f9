// Cells of fixed width, and quoted cells whose quotes are not escaped: the text exports of SIMATIC tools.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::read {

/// `text` without the blanks and TABs around it.
std::string_view without_blanks(std::string_view text);

/// `text` with one blank instead of each run of blanks: `I 11.6` for `I      11.6`.
std::string squeezed(std::string_view text);

/// Removes the first `columns` columns from `text` and returns them without the blanks around; the whole text if it is
/// shorter. A character has one column, wide ones (Chinese, Japanese, Korean) have two, as in their code pages.
std::string_view cut_columns(std::string_view& text, std::size_t columns);

/// Splits a line of cells in quotes, separated by commas, where quotes inside a cell are not escaped. All but one cell
/// are found from the line's beginning (`before`) and end (`after`), so that the one between may have quotes and
/// commas. Fills `cells` with before + 1 + after cells, without quotes but with blanks. False if the line has fewer
/// cells or its quotes are missing.
bool split_quoted(std::string_view line, std::size_t before, std::size_t after, std::vector<std::string_view>& cells);

}  // namespace symplant::read
