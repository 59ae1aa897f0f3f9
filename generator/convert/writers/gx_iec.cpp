// Writes global variable lists of GX IEC Developer 7.
#include <string>

#include "convert/addresses.hpp"
#include "convert/cells.hpp"
#include "convert/formats.hpp"
#include "convert/identifiers.hpp"
#include "convert/losses.hpp"
#include "convert/types.hpp"

namespace symplant::convert {
namespace {

constexpr Loss kNotIdentifiers{"name is not an identifier", "names are not identifiers",
                               "GX IEC Developer may reject it, it is written unchanged"};

struct GxAddresses {
  std::string mitsubishi;
  std::string iec;
};

bool is_melsec(const Symbol& symbol) { return symbol.notation == address::Notation::melsec; }

GxAddresses gx_addresses(const Symbol& symbol, std::optional<address::Radix> xy) {
  GxAddresses addresses;
  if (is_melsec(symbol)) {
    addresses = {std::string(symbol.row->vendor_address), std::string(symbol.row->iec_address)};
  } else if (xy && symbol.address) {
    addresses.mitsubishi = melsec_device(*symbol.address, *xy);
  }
  if (addresses.iec.empty()) addresses.iec = address_in(symbol, kGxIecForm);
  return addresses;
}

std::string_view gx_class(const Symbol& symbol) {
  if (is_melsec(symbol) && !symbol.row->klass.empty()) return symbol.row->klass;
  return symbol.kind == Kind::constant ? "VAR_GLOBAL_CONSTANT" : "VAR_GLOBAL";
}

void append_gx_row(std::string& text, const Symbol& symbol, std::optional<address::Radix> xy) {
  const GxAddresses addresses = gx_addresses(symbol, xy);
  const std::string_view type = symbol.row->type;
  append_cell(text, gx_class(symbol));
  append_cell(text += ',', symbol.row->name);
  append_cell(text += ',', addresses.mitsubishi);
  append_cell(text += ',', addresses.iec);
  append_cell(text += ',', is_melsec(symbol) ? std::string(type) : iec_type(symbol).value_or(std::string(type)));
  append_cell(text += ',', symbol.row->initial);
  append_cell(text += ',', symbol.row->comment);
  text += '\n';
}

base::Result<Output, WriteError> write_gx_iec(const Writing& writing) {
  Written written;
  for (const Symbol& symbol : writing.symbols->all) {
    written.add(symbol);
    const std::string_view name = symbol.row->name;
    const GxAddresses addresses = gx_addresses(symbol, writing.xy);
    const bool has_address = !addresses.mitsubishi.empty() || !addresses.iec.empty();
    if (!has_address && !source_address(symbol).empty()) writing.report.add(kNoEquivalentAddress, name);
    if (!is_iec_identifier(name)) writing.report.add(kNotIdentifiers, name);
    report_scope(symbol, writing.report);
  }
  const base::TextSource text = [symbols = writing.symbols, xy = writing.xy](base::TextSink& sink) {
    base::PartCollector parts(sink);
    parts.add("Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n");
    std::string row;
    for (const Symbol& symbol : symbols->all) {
      row.clear();
      append_gx_row(row, symbol, xy);
      parts.add(row);
    }
    parts.finish();
  };
  return Output{text, written};
}

}  // namespace

const WriterInfo kGxIecWriter{"gx-iec", "GX IEC Developer 7 global variable list", ".txt", false, true, write_gx_iec};

}  // namespace symplant::convert
