// Writes a table with a header that any tool can read, as comma-separated text.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <string>

#include "convert/addresses.hpp"
#include "convert/cells.hpp"
#include "convert/formats.hpp"
#include "read/own_table.hpp"

namespace symplant::convert {
namespace {

constexpr Loss kOtherNotation{"address is read differently", "addresses are read differently",
                              "the list has addresses of several notations; convert its parts one by one"};

bool is_io(const Symbol& symbol) { return symbol.address && symbol.address->area != address::Area::memory; }

bool has_direction(const Symbol& symbol) {
  return !symbol.address && (symbol.kind == Kind::input || symbol.kind == Kind::output);
}

bool has_class(const Symbol& symbol) { return symbol.kind == Kind::constant; }

bool has_address(const Symbol& symbol) { return !source_address(symbol).empty(); }

bool has_scope(const Symbol& symbol) { return !symbol.extra->scope.empty(); }

/// The columns that only some lists need, and how addresses are written.
struct CsvShape {
  bool direction = false;
  bool klass = false;
  bool scope = false;
  bool iec_addresses = false;    ///< of inputs and outputs: X and Y that a reader would count in another base
  bool names_notation = false;   ///< the addresses do not show it
  address::Notation notation{};  ///< of the addresses, for a reader
};

std::string csv_address(const Symbol& symbol, const CsvShape& shape) {
  if (shape.iec_addresses && is_io(symbol) && symbol.notation == address::Notation::melsec) {
    if (std::string text = address_in(symbol, kGxIecForm); !text.empty()) return text;
  }
  return std::string(source_address(symbol));
}

address::Notation notation_of(const Symbols& symbols, const CsvShape& shape) {
  std::deque<std::string> cells;
  read::OwnNotation notation;
  for (const Symbol& symbol : symbols.all) {
    if (notation.is_full()) break;
    notation.add(cells.emplace_back(csv_address(symbol, shape)));
  }
  return notation.notation();
}

CsvShape csv_shape(const Symbols& symbols) {
  const auto any = [&](bool (*has)(const Symbol&)) { return std::any_of(symbols.all.begin(), symbols.all.end(), has); };
  CsvShape shape;
  shape.direction = any(has_direction);
  shape.klass = any(has_class);
  shape.scope = any(has_scope);
  shape.iec_addresses = any([](const Symbol& symbol) {
    return symbol.octal && symbol.notation == address::Notation::melsec && is_io(symbol) && symbol.address->number >= 8;
  });
  if (symbols.all.empty()) return shape;
  shape.notation = notation_of(symbols, shape);
  const address::Notation first = symbols.all.front().notation;
  const auto is_first = [&](const Symbol& symbol) { return symbol.notation == first; };
  if (shape.notation != first && any(has_address) && std::all_of(symbols.all.begin(), symbols.all.end(), is_first)) {
    shape.names_notation = true;
    shape.notation = first;
  }
  return shape;
}

/// Whether a reader of the table gets the same address.
bool reads_back(const Symbol& symbol, const CsvShape& shape) {
  if (!is_io(symbol)) return true;
  const std::string text = csv_address(symbol, shape);
  const auto address = address::parse(text, {shape.notation, address::Radix::hexadecimal, symbol.io_words});
  return (address ? address : address::parse_iec(text)) == symbol.address;
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
  if (shape.names_notation) {
    append_cell(text += ',', read::kNotationNames[static_cast<std::size_t>(shape.notation)]);
  }
  text += '\n';
}

base::Result<Output, WriteError> write_csv(const Writing& writing) {
  const CsvShape shape = csv_shape(*writing.symbols);
  Written written;
  for (const Symbol& symbol : writing.symbols->all) {
    written.add(symbol);
    if (!reads_back(symbol, shape)) writing.report.add(kOtherNotation, symbol.row->name);
  }
  const base::TextSource text = [symbols = writing.symbols, shape](base::TextSink& sink) {
    base::PartCollector parts(sink);
    std::string row = fmt::format("{}", fmt::join(read::kOwnColumns, ","));
    if (shape.direction) row += ",Direction";
    if (shape.scope) row += ",Scope";
    if (shape.klass) row += ",Class";
    if (shape.names_notation) row.append(",").append(read::kNotationColumn);
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
