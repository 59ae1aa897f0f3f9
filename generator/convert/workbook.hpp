// Writes workbooks (.xlsx) of text cells.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "base/index_table.hpp"
#include "base/result.hpp"
#include "convert/writer.hpp"

namespace symplant::convert {

/// The most rows of a sheet, with its header.
inline constexpr std::size_t kMostSheetRows = 1048576;
/// The most characters of a cell.
inline constexpr std::size_t kMostCellCharacters = 32767;

/// Keeps each text once. Views must outlive this object.
class SharedStrings {
 public:
  std::uint32_t add(std::string_view text);
  /// Like add(), for a text that this object must own.
  std::uint32_t keep(std::string text);
  const std::vector<std::string_view>& all() const { return all_; }

 private:
  std::vector<std::string_view> all_;
  base::IndexTable by_text_;
  std::deque<std::string> kept_;
};

struct SheetTable {
  std::string name;
  std::size_t columns;
  std::vector<std::uint32_t> cells;  ///< row by row, as indexes of shared strings; the header first

  std::size_t rows() const { return cells.size() / columns; }
};

/// The bytes of the workbook.
base::Result<std::string, WriteError> workbook_bytes(const std::vector<SheetTable>& sheets,
                                                     const SharedStrings& strings);

}  // namespace symplant::convert
