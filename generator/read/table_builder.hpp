// Builds a symbol table row by row, for the readers of formats.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "read/reader.hpp"
#include "read/symbol_table.hpp"

namespace symplant::read {

class TableBuilder {
 public:
  TableBuilder(const Reading& reading, address::Notation notation);

  const text::SourceFile& source() const { return *reading_.source; }
  std::string_view text() const { return reading_.source->text(); }
  SymbolTable& table() { return table_; }

  /// A cell whose text is not in the file as such (escapes, entities). O(text).
  std::string_view keep(std::string text);
  /// The cell `value`, read from `offset` of the file: a view into the file if it is there as such, else kept.
  std::string_view cell(std::size_t offset, std::string_view value);

  /// A new row that begins at `whole.begin`; `line` counts from 1. The reference is valid until the next call.
  ListRow& add(text::Span whole, std::uint32_t line);
  /// The index of an extra that has only a scope, for `extra` of all rows of the scope. It must not be changed.
  /// kNoExtra for an empty scope.
  std::uint32_t extra_for_scope(std::string_view scope);
  /// The row's extra, to be filled.
  RowExtra& extra(ListRow& row);

  /// The next row begins another list in the same text, as a repeated header shows.
  void begin_part() { table_.parts.push_back(table_.rows.size()); }

  /// For --verbose.
  void decide(std::string decision) { table_.decisions.push_back(std::move(decision)); }
  /// Adds a finding about bytes of the file.
  void report(const diag::RuleInfo& rule, std::string message, text::Span where);

  /// The table, or nothing, with an error, if it has no row (SP104) or a cell that is too long (SP111).
  std::optional<SymbolTable> finish();
  /// Like finish(), for formats in which no cell can be too long.
  std::optional<SymbolTable> finish_bounded();

 private:
  bool has_cell_too_long();

  const Reading& reading_;
  SymbolTable table_;
};

}  // namespace symplant::read
