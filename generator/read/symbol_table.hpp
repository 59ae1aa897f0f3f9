// A symbol list as it was read: all rows, not yet checked.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "text/source_file.hpp"

namespace symplant::read {

/// One row that declares a symbol. Views point into the file's text or into the table's `arena`. Blanks around a cell
/// are removed; a missing cell is empty.
struct ListRow {
  std::string_view klass;  ///< VAR_GLOBAL, VAR_GLOBAL_CONSTANT ...
  std::string_view name;
  std::string_view vendor_address;  ///< MIT-Addr.
  std::string_view iec_address;     ///< IEC-Addr.
  std::string_view type;
  std::string_view initial;
  std::string_view comment;
  std::uint32_t line;  ///< the line at which it begins, counted from 1
  text::Span whole;    ///< the row's bytes, without its line end
};

/// Movable but not copyable, because its rows point into it.
struct SymbolTable {
  SymbolTable() = default;
  SymbolTable(SymbolTable&&) = default;
  SymbolTable& operator=(SymbolTable&&) = default;
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  std::shared_ptr<const text::SourceFile> source;
  std::vector<ListRow> rows;
  std::deque<std::string> arena;       ///< cells whose text differs from the file's ("" for ")
  std::vector<std::string> decisions;  ///< what was recognized and why, for --verbose
};

}  // namespace symplant::read
