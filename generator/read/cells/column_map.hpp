// What the user says about the columns of a table: `--columns name=Tag,address=3`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "read/cells/columns.hpp"

namespace symplant::read {

/// A column that the user names by its header or its number.
struct GivenColumn {
  Field field{};
  std::string header;      ///< compared as headers are; empty: by number
  std::size_t number = 0;  ///< counted from 1; 0: by header
};

struct ColumnMap {
  std::vector<GivenColumn> columns;
  std::string sheet;  ///< of a workbook; empty: the sheet that holds a list

  bool empty() const { return columns.empty() && sheet.empty(); }
};

/// Adds `word` = `column` to a map: a field ("name", "address", "iec-address", "type", "initial", "comment", "class",
/// "scope") and the header or number of its column, or `sheet` and the sheet's name. The error is a message for the
/// user.
base::Result<ColumnMap, std::string> with_column(ColumnMap map, std::string_view word, std::string_view column);

/// Reads "name=Tag,address=3,sheet=IO list". The error is a message for the user.
base::Result<ColumnMap, std::string> column_map_of(std::string_view text);

}  // namespace symplant::read
