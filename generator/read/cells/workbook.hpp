// Reads the sheets of a workbook (.xlsx) as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace symplant::read {

/// A sheet as text: a line for each row, cells separated by TAB and quoted where they begin with `"`; line ends and
/// TABs in cells are blanks. Line n is row n of the sheet.
struct Sheet {
  std::string name;
  std::string text;
};

/// Whether the bytes are those of a workbook.
bool is_workbook(std::string_view bytes);

/// All sheets in their order. The error says what is wrong and what to do. Reads as a stream, with limits on the number
/// of parts, the unpacked size and its ratio to the packed one; O(unpacked bytes).
base::Result<std::vector<Sheet>, std::string> read_workbook(std::string_view bytes);

}  // namespace symplant::read
