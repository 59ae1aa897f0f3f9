// A symbol list as it was read: all rows, not yet checked.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "address/notation.hpp"
#include "text/source_file.hpp"

namespace symplant::read {

inline constexpr std::uint32_t kNoExtra = UINT32_MAX;

/// One row that declares a symbol. Views point into the file's text or into the table's `arena`. Blanks around a cell
/// are removed; a missing cell is empty.
struct ListRow {
  std::string_view klass;           ///< VAR_GLOBAL, VAR_GLOBAL_CONSTANT ...
  std::string_view name;            ///< for an address without a name: the same view as its cell
  std::string_view vendor_address;  ///< in the table's notation
  std::string_view iec_address;     ///< an IEC 61131-3 address next to the vendor's (`IEC-Addr.`)
  std::string_view type;
  std::string_view initial;
  std::string_view comment;
  std::uint32_t line = 0;          ///< the line at which it begins, counted from 1
  std::uint32_t extra = kNoExtra;  ///< index in the table's `extras`
  /// Whether the list has no name for it, and its address is its name.
  bool is_named_by_address() const {
    return !name.empty() && (name.data() == vendor_address.data() || name.data() == iec_address.data());
  }

  text::Span whole;  ///< the row's bytes, without its line end
};

/// What only few rows have.
struct RowExtra {
  std::string_view parent_comment;  ///< of the word, module or structure of which the row is a part
  std::string_view scope;           ///< program, tag table or sheet that declares it; empty: the controller's
  std::string_view alias;           ///< the written operand from which `vendor_address` was resolved
};

/// Movable but not copyable, because its rows point into it.
struct SymbolTable {
  SymbolTable() = default;
  SymbolTable(SymbolTable&&) = default;
  SymbolTable& operator=(SymbolTable&&) = default;
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  /// The row's extra, or one without content.
  const RowExtra& extra_of(const ListRow& row) const {
    static const RowExtra none;
    return row.extra == kNoExtra ? none : extras[row.extra];
  }

  std::shared_ptr<const text::SourceFile> source;
  address::Notation notation = address::Notation::melsec;  ///< of the vendor addresses
  address::IoRanges io_words;                              ///< which words of a shared area are inputs or outputs
  std::vector<ListRow> rows;
  std::vector<RowExtra> extras;
  std::vector<std::size_t> parts;      ///< rows at which another list begins in the same text
  std::deque<std::string> arena;       ///< cells whose text differs from the file's ("" for ")
  std::string_view title;              ///< of the format
  std::string summary;                 ///< what was taken for what: "name: column 2 `Tag`, address: column 4 `Operand`"
  std::vector<std::string> decisions;  ///< what was recognized and why, for --verbose
};

}  // namespace symplant::read
