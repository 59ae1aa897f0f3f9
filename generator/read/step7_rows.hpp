// Rows of the symbol tables of STEP 7, whose cells are padded with blanks.
#pragma once

#include <string_view>

#include "read/cells/lines.hpp"
#include "read/table_builder.hpp"

namespace symplant::read {

/// The cells of a row, without blanks around.
struct Step7Cells {
  std::string_view name;
  std::string_view address;  ///< `I      11.6`: the operand left, the number right
  std::string_view type;     ///< `BOOL`; of a block the block itself, `FB     10`
  std::string_view comment;
};

/// Adds a row; reports one without name and leaves it out.
void add_step7_row(TableBuilder& builder, const Line& line, const Step7Cells& cells);

}  // namespace symplant::read
