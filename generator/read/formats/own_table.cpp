// Reads the table that symplant writes as CSV.
#include "read/own_table.hpp"

#include <algorithm>

#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

std::optional<Layout> own_table_layout(std::string_view text) {
  constexpr std::array<std::string_view, 5> kOwnHeader{"name", "address", "type", "initial", "comment"};
  auto layout = below_header_with(text, kOwnHeader);
  if (!layout || layout->header.size() < kOwnColumns.size()) return std::nullopt;
  if (!std::equal(kOwnColumns.begin(), kOwnColumns.end(), layout->header.begin())) return std::nullopt;
  layout->columns.set(Field::iec_address, kNoColumn);
  layout->columns.set(Field::vendor_address, 1);
  return layout;
}

int own_table_likelihood(std::string_view text) { return own_table_layout(text) ? kKnownHeader : 0; }

/// The notation that the first row names.
std::optional<address::Notation> named_notation(std::string_view text, const Layout& layout) {
  const auto column = std::find(layout.header.begin(), layout.header.end(), kNotationColumn);
  std::deque<std::string> arena;
  const std::vector<CsvRow> rows = sample_rows(text, layout, arena);
  if (column == layout.header.end() || rows.empty()) return std::nullopt;
  const std::string_view cell = rows.front().cell(static_cast<std::size_t>(column - layout.header.begin()));
  const auto name = std::find(kNotationNames.begin(), kNotationNames.end(), cell);
  if (name == kNotationNames.end()) return std::nullopt;
  return static_cast<address::Notation>(name - kNotationNames.begin());
}

std::optional<SymbolTable> read_own_table(const Reading& reading) {
  const auto layout = own_table_layout(reading.source->text());
  if (!layout) return kAnyTable.read(reading);
  auto table = read_table(reading, *layout, {.is_protected = true});
  if (!table) return std::nullopt;
  OwnNotation shown;
  for (const ListRow& row : table->rows) shown.add(row.vendor_address);
  const auto named = named_notation(reading.source->text(), *layout);
  table->notation = named ? *named : shown.notation();
  return table;
}

}  // namespace

const ReaderInfo kOwnTable{"csv", "table that symplant convert writes", own_table_likelihood, read_own_table};

}  // namespace symplant::read
