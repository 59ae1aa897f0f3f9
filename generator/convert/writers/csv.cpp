// Writes a table with a header that any tool can read, as comma-separated text.
#include <algorithm>
#include <string>

#include "convert/addresses.hpp"
#include "convert/cells.hpp"
#include "convert/formats.hpp"

namespace symplant::convert {
namespace {

bool has_direction(const Symbol& symbol) {
  return !symbol.address && (symbol.kind == Kind::input || symbol.kind == Kind::output);
}

bool has_class(const Symbol& symbol) { return symbol.kind == Kind::constant; }

bool has_scope(const Symbol& symbol) { return !symbol.extra->scope.empty(); }

/// The columns that only some lists need, and how their addresses are written.
struct CsvShape {
  bool direction;
  bool klass;
  bool scope;
  /// X and Y that do not count in hexadecimal, as readers expect, are written as IEC addresses.
  bool iec;
};

CsvShape csv_shape(const Symbols& symbols) {
  const auto any = [&](bool (*has)(const Symbol&)) { return std::any_of(symbols.all.begin(), symbols.all.end(), has); };
  const auto needs_iec = [](const Symbol& symbol) {
    return symbol.octal && symbol.address && symbol.address->number >= 8 &&
           symbol.address->area != address::Area::memory && symbol.notation == address::Notation::melsec;
  };
  return {any(has_direction), any(has_class), any(has_scope), any(needs_iec)};
}

std::string csv_address(const Symbol& symbol, const CsvShape& shape) {
  const bool is_io = symbol.address && symbol.address->area != address::Area::memory && symbol.address->plain;
  if (shape.iec && is_io) return address_in(symbol, kGxIecForm);
  return std::string(source_address(symbol));
}

std::string_view csv_direction(const Symbol& symbol) {
  return !has_direction(symbol) ? "" : symbol.kind == Kind::input ? "input" : "output";
}

void append_csv_row(std::string& text, const Symbol& symbol, const CsvShape& shape) {
  append_protected_cell(text, symbol.row->name);
  append_protected_cell(text += ',', csv_address(symbol, shape));
  append_protected_cell(text += ',', symbol.row->type);
  append_protected_cell(text += ',', symbol.row->initial);
  append_protected_cell(text += ',', symbol.row->comment);
  if (shape.direction) append_cell(text += ',', csv_direction(symbol));
  if (shape.scope) append_protected_cell(text += ',', symbol.extra->scope);
  if (shape.klass) append_cell(text += ',', has_class(symbol) ? "VAR_GLOBAL_CONSTANT" : "VAR_GLOBAL");
  text += '\n';
}

base::Result<Output, WriteError> write_csv(const Writing& writing) {
  const CsvShape shape = csv_shape(*writing.symbols);
  Written written;
  for (const Symbol& symbol : writing.symbols->all) written.add(symbol);
  const base::TextSource text = [symbols = writing.symbols, shape](base::TextSink& sink) {
    base::PartCollector parts(sink);
    std::string row = "Name,Address,Type,Initial,Comment";
    if (shape.direction) row += ",Direction";
    if (shape.scope) row += ",Scope";
    if (shape.klass) row += ",Class";
    parts.add(row += '\n');
    for (const Symbol& symbol : symbols->all) {
      row.clear();
      append_csv_row(row, symbol, shape);
      parts.add(row);
    }
    parts.finish();
  };
  return Output{text, written};
}

}  // namespace

const WriterInfo kCsvWriter{
    "csv", "table with the columns Name, Address, Type, Initial, Comment", ".csv", false, true, write_csv};

}  // namespace symplant::convert
