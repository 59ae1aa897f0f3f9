// Scans the usual line of a trace: a change of a symbol.
#pragma once

#include <optional>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::trace {

/// A line that is only a change of a symbol.
struct PlainChange {
  tables::Time time = 0;
  std::string_view symbol;
  double value = 0;  ///< of a BOOL 0 or 1
  bool is_boolean = false;
};

/// The change of `{"t":0,"symbol":"X","value":true}`, exactly in this form, as a JSON reader would read it. Nothing for
/// all other lines, which may be right, too: names with escapes or beyond ASCII, other keys, another order, blanks.
/// O(line).
std::optional<PlainChange> plain_change(std::string_view line);

}  // namespace symplant::trace
