// A symbol list as it was read: every row, nothing judged yet.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "text/source_file.hpp"

namespace symplant::read {

/// One row that declares a symbol. Views point into the file's text or into the table's `arena`; blanks around a cell
/// are gone, a missing cell is empty.
struct ListRow {
  std::string_view klass;  ///< VAR_GLOBAL, VAR_GLOBAL_CONSTANT ...
  std::string_view name;
  std::string_view vendor_address;  ///< MIT-Addr.
  std::string_view iec_address;     ///< IEC-Addr.
  std::string_view type;
  std::string_view initial;
  std::string_view comment;
  std::uint32_t line;  ///< where it begins in the file, counted from 1
  text::Span whole;    ///< the row's bytes, without its line end
};

/// Movable, not copyable: its rows point into it.
struct SymbolTable {
  SymbolTable() = default;
  SymbolTable(SymbolTable&&) = default;
  SymbolTable& operator=(SymbolTable&&) = default;
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  std::shared_ptr<const text::SourceFile> source;
  std::vector<ListRow> rows;
  std::deque<std::string> arena;       ///< cells whose text is not in the file as it is ("" for ")
  std::vector<std::string> decisions;  ///< what was sniffed and why, for --verbose
};

}  // namespace symplant::read
