// The values in the cells of a table.
#pragma once

#include <optional>
#include <string_view>

namespace symplant::recording {

struct CellValue {
  enum class Kind : unsigned char {
    word,    ///< TRUE or FALSE
    bit,     ///< 0 or 1: a BOOL or a number
    number,  ///< any other number
  };
  double number = 0;
  Kind kind = Kind::number;
};

/// A truth value as a word (also ON and OFF), or a number with a decimal point or comma. Nothing for other texts, `nan`
/// and `inf` included. O(cell).
std::optional<CellValue> cell_value(std::string_view cell);

/// Whether a text says that there is no value: `nan`, `null`, `n/a`, `bad`, `---` and the like, as loggers
/// write them while a connection is lost.
bool is_no_value(std::string_view cell);

}  // namespace symplant::recording
