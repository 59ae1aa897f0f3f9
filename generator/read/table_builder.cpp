// Builds a symbol table row by row.
#include "read/table_builder.hpp"

#include <utility>

#include "read/rules/cell_too_long.hpp"
#include "read/rules/header_alone.hpp"

namespace symplant::read {

TableBuilder::TableBuilder(const Reading& reading, address::Notation notation) : reading_(reading) {
  table_.source = reading.source;
  table_.notation = notation;
}

std::string_view TableBuilder::keep(std::string text) { return table_.arena.emplace_back(std::move(text)); }

std::string_view TableBuilder::cell(std::size_t offset, std::string_view value) {
  const std::string_view in_file = offset <= text().size() ? text().substr(offset, value.size()) : std::string_view();
  return in_file == value ? in_file : keep(std::string(value));
}

ListRow& TableBuilder::add(text::Span whole, std::uint32_t line) {
  ListRow& row = table_.rows.emplace_back();
  row.line = line;
  row.whole = whole;
  return row;
}

std::uint32_t TableBuilder::extra_for_scope(std::string_view scope) {
  if (scope.empty()) return kNoExtra;
  table_.extras.push_back({.parent_comment = {}, .scope = scope, .alias = {}});
  return static_cast<std::uint32_t>(table_.extras.size() - 1);
}

RowExtra& TableBuilder::extra(ListRow& row) {
  if (row.extra == kNoExtra) {
    row.extra = static_cast<std::uint32_t>(table_.extras.size());
    table_.extras.emplace_back();
  }
  return table_.extras[row.extra];
}

void TableBuilder::report(const diag::RuleInfo& rule, std::string message, text::Span where) {
  reading_.diagnostics.add(rule, std::move(message), {reading_.source, where});
}

bool TableBuilder::has_cell_too_long() {
  for (const ListRow& row : table_.rows) {
    for (const std::string_view cell :
         {row.klass, row.name, row.vendor_address, row.iec_address, row.type, row.initial}) {
      if (cell.size() <= kLongestCell) continue;
      const text::Span location = source().span_of(cell, row.whole);
      report(kCellTooLong,
             "this cell has " + std::to_string(cell.size()) + " bytes, but at most " + std::to_string(kLongestCell) +
                 " are allowed; add the missing line end or quote",
             {location.begin, location.begin + 1});
      return true;
    }
  }
  return false;
}

std::optional<SymbolTable> TableBuilder::finish() { return has_cell_too_long() ? std::nullopt : finish_bounded(); }

std::optional<SymbolTable> TableBuilder::finish_bounded() {
  if (!table_.rows.empty()) return std::move(table_);
  report(kHeaderAlone, "the file declares no symbol; export the list again with its symbols",
         source().span_of(source().line_at(0)));
  return std::nullopt;
}

}  // namespace symplant::read
