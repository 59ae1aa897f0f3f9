// Reads I/O tag lists of LS Electric XG5000: global variables, and again those that each program uses.
#include <fmt/format.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array<HeaderWords, 1> kLsTagsHeaders{{{"scope", "variable", "address", "datatype"}}};

bool is_ls_tags_remark(const CsvRow& row) { return row.cell(0) == "Remark"; }

/// Removes the rows of programs that repeat a variable of the same part of the text: one of the PLC, or of a program
/// before. Rows that are left have no scope: it is `GlobalVariable`, or a program.
void keep_one_of_each(SymbolTable& table) {
  std::set<std::tuple<std::size_t, std::string_view, std::string_view, std::string_view>> known;
  const auto is_global = [&](const ListRow& row) { return table.extra_of(row).scope == "GlobalVariable"; };
  const auto key = [](std::size_t part, const ListRow& row) {
    return std::tuple(part, row.name, row.vendor_address, row.iec_address);
  };
  const auto for_each_row = [&](auto take) {
    std::size_t part = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      while (part < table.parts.size() && table.parts[part] <= i) ++part;
      take(part, table.rows[i]);
    }
  };
  for_each_row([&](std::size_t part, const ListRow& row) {
    if (is_global(row)) known.insert(key(part, row));
  });
  std::vector<ListRow> kept;
  std::vector<std::size_t> parts;
  kept.reserve(table.rows.size());
  for_each_row([&](std::size_t part, ListRow& row) {
    while (parts.size() < part) parts.push_back(kept.size());
    if (!is_global(row) && !known.insert(key(part, row)).second) return;
    kept.push_back(row);
    kept.back().extra = kNoExtra;
  });
  const std::size_t repeated = table.rows.size() - kept.size();
  if (repeated != 0) table.decisions.push_back(fmt::format("rows of programs that repeat a variable: {}", repeated));
  table.rows = std::move(kept);
  table.parts = std::move(parts);
}

int ls_tags_likelihood(std::string_view text) { return layout_in_any(text, kLsTagsHeaders) ? kKnownHeader : 0; }

std::optional<SymbolTable> read_ls_tags(const Reading& reading) {
  auto layout = layout_in_any(reading.source->text(), kLsTagsHeaders);
  if (!layout) return kAnyTable.read(reading);
  auto table = read_table(reading, *layout, {.notation = address::Notation::iec, .is_remark = is_ls_tags_remark});
  if (table) keep_one_of_each(*table);
  return table;
}

}  // namespace

const ReaderInfo kLsTags{"ls-tags", "LS XG5000 tag list", ls_tags_likelihood, read_ls_tags};

}  // namespace symplant::read
