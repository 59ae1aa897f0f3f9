// Declarations of arrays of elementary types.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::read {

struct ArrayType {
  struct Dimension {
    std::int64_t first = 0;
    std::int64_t last = 0;  ///< at least `first`
  };

  std::string_view element;  ///< the element's type, as written
  tables::DataType type{};
  std::vector<Dimension> dimensions;  ///< at least one; the last one counts fastest

  /// The number of elements, at most `limit`.
  std::uint64_t count(std::uint64_t limit) const;
};

/// Reads ARRAY [0..7] OF BOOL, Array[0..1, 0..3] of Int, BOOL(0..9), DINT[9] (0 to 8). Nothing for any other type, and
/// if the element is not elementary.
std::optional<ArrayType> parse_array_type(std::string_view text);

/// Whether a text may be an array's type: a quick test before parse_array_type().
constexpr bool may_be_array(std::string_view type) {
  return type.size() > 4 && (type.front() == 'A' || type.front() == 'a' || type.back() == ']' || type.back() == ')');
}

}  // namespace symplant::read
