// Reads tag tables of TIA Portal: the workbook, or the same columns as text.
#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array kTiaTagsHeaders{HeaderWords{"name", "datatype", "logicaladdress"},
                                     HeaderWords{"name", "datentyp", "logischeadresse"}};

int tia_tags_likelihood(std::string_view text) { return layout_in_any(text, kTiaTagsHeaders) ? kKnownHeader : 0; }

std::optional<SymbolTable> read_tia_tags(const Reading& reading) {
  auto layout = layout_in_any(reading.source->text(), kTiaTagsHeaders);
  if (!layout) return kAnyTable.read(reading);
  if (!layout->columns.has(Field::vendor_address)) {  // `Logische Adresse`
    layout->columns.set(Field::vendor_address, layout->columns[Field::iec_address]);
    layout->columns.set(Field::iec_address, kNoColumn);
  }
  return read_table(reading, *layout, {.notation = address::Notation::siemens});
}

}  // namespace

const ReaderInfo kTiaTags{"tia-tags", "TIA Portal tag table (workbook)", tia_tags_likelihood, read_tia_tags};

}  // namespace symplant::read
