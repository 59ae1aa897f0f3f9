// Reads the I/O mapping of CODESYS 3 and its brands: channels of devices, with or without a variable.
#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array<HeaderWords, 1> kCodesysIoMappingHeaders{{{"mappedvariable", "iecaddress"}}};

bool is_codesys_io_mapping_remark(const CsvRow& row) { return row.cell(0).starts_with("//"); }

std::optional<Layout> codesys_io_mapping_layout(std::string_view text) {
  auto layout = layout_in_any(text, kCodesysIoMappingHeaders);
  if (!layout) return std::nullopt;
  layout->columns.set(Field::scope, layout->columns[Field::vendor_address]);  // `Device name`: a module
  layout->columns.set(Field::vendor_address, kNoColumn);
  return layout;
}

int codesys_io_mapping_likelihood(std::string_view text) { return codesys_io_mapping_layout(text) ? kKnownHeader : 0; }

std::optional<SymbolTable> read_codesys_io_mapping(const Reading& reading) {
  const auto layout = codesys_io_mapping_layout(reading.source->text());
  if (!layout) return kAnyTable.read(reading);
  return read_table(
      reading, *layout,
      {.notation = address::Notation::iec, .address_for_name = true, .is_remark = is_codesys_io_mapping_remark});
}

}  // namespace

const ReaderInfo kCodesysIoMapping{"codesys-io-mapping", "CODESYS I/O mapping", codesys_io_mapping_likelihood,
                                   read_codesys_io_mapping};

}  // namespace symplant::read
