// Reads the rows of a delimited list whose columns are known.
#pragma once

#include <optional>
#include <string_view>

#include "read/cells/layout.hpp"
#include "read/reader.hpp"

namespace symplant::read {

/// How the rows of a kind of list are read.
struct TableKind {
  address::Notation notation = address::Notation::melsec;
  /// Whether a row with an address and no name is a symbol, with its address as its name.
  bool address_for_name = false;
  /// Whether the content of a cell, not its column, decides if it is a vendor's or an IEC address.
  bool sort_addresses = false;
  /// Whether an apostrophe may protect a cell from being run as a formula.
  bool is_protected = false;
  /// Whether a row is a remark, not a symbol; null: no row is.
  bool (*is_remark)(const CsvRow& row) = nullptr;
};

/// Returns nothing if it added an error: an unclosed quote, a cell that is too long, no row. O(text).
std::optional<SymbolTable> read_table(const Reading& reading, const Layout& layout, const TableKind& kind);

/// The cells of a column in the first rows.
std::vector<std::string_view> sample_cells(const std::vector<CsvRow>& rows, std::size_t column);

}  // namespace symplant::read
