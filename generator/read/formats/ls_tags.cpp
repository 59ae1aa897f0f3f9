// Reads I/O tag lists of LS Electric XG5000.
#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array<HeaderWords, 1> kLsTagsHeaders{{{"scope", "variable", "address", "datatype"}}};

bool is_ls_tags_remark(const CsvRow& row) { return row.cell(0) == "Remark"; }

int ls_tags_likelihood(std::string_view text) { return layout_in_any(text, kLsTagsHeaders) ? kKnownHeader : 0; }

std::optional<SymbolTable> read_ls_tags(const Reading& reading) {
  auto layout = layout_in_any(reading.source->text(), kLsTagsHeaders);
  if (!layout) return kAnyTable.read(reading);
  layout->columns.set(Field::scope, kNoColumn);  // `GlobalVariable` in every row
  return read_table(reading, *layout, {.notation = address::Notation::iec, .is_remark = is_ls_tags_remark});
}

}  // namespace

const ReaderInfo kLsTags{"ls-tags", "LS XG5000 tag list", ls_tags_likelihood, read_ls_tags};

}  // namespace symplant::read
