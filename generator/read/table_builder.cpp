// Builds a symbol table row by row.
#include "read/table_builder.hpp"

#include <utility>

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

std::optional<SymbolTable> TableBuilder::finish() {
  if (!table_.rows.empty()) return std::move(table_);
  report(kHeaderAlone, "the file declares no symbol; export the list again with its symbols",
         source().span_of(source().line_at(0)));
  return std::nullopt;
}

}  // namespace symplant::read
