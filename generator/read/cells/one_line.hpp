// Cells of formats whose texts may have line ends.
#pragma once

#include <cstddef>
#include <string_view>

#include "read/table_builder.hpp"

namespace symplant::read {

/// A cell that begins at `offset` of the file (npos: unknown), on one line: line ends, tabs and other control
/// characters, together with the blanks around them, become one blank. Blanks around the text are removed, and what is
/// not UTF-8 becomes U+FFFD. A view into the file if the file has the cell in this form. O(text).
std::string_view one_line(TableBuilder& builder, std::size_t offset, std::string_view text);

}  // namespace symplant::read
