// Reads global variables of Sysmac Studio, exported for CX-Designer.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "read/cells/csv.hpp"
#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/rules/text_after_quote.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/rules/unknown_format.hpp"
#include "read/table_builder.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

enum SysmacColumn : std::uint8_t { host, name, datatype, address_column, comment, tag_link, read_write, pou };
constexpr std::array<std::string_view, 8> kSysmacColumns{"HOST",    "NAME",    "DATATYPE", "ADDRESS",
                                                         "COMMENT", "TAGLINK", "RW",       "POU"};
using SysmacIndexes = std::array<std::size_t, kSysmacColumns.size()>;

/// Where each column is; nothing if the row is not the header.
std::optional<SysmacIndexes> sysmac_indexes_of(const CsvRow& row) {
  SysmacIndexes indexes{};
  for (std::size_t i = 0; i < kSysmacColumns.size(); ++i) {
    const auto found = std::find_if(row.cells.begin(), row.cells.end(), [&](std::string_view cell) {
      return text::equal_ignoring_case(cell, kSysmacColumns[i]);
    });
    indexes[i] = found == row.cells.end() ? kMaxCells : static_cast<std::size_t>(found - row.cells.begin());
  }
  const bool known = indexes[name] != kMaxCells && indexes[datatype] != kMaxCells &&
                     (indexes[tag_link] != kMaxCells || indexes[host] != kMaxCells);
  return known ? std::optional(indexes) : std::nullopt;
}

int sysmac_likelihood(std::string_view text) {
  LineReader lines(text);
  Line line;
  while (lines.next(line)) {
    if (without_blanks(line.text).empty()) continue;
    std::deque<std::string> arena;
    CsvReader rows(line.text, '\t', arena);
    CsvRow row;
    return rows.next(row) && sysmac_indexes_of(row) ? 95 : 0;
  }
  return 0;
}

void add_sysmac_row(TableBuilder& builder, const CsvRow& row, const SysmacIndexes& indexes) {
  const auto cell = [&](SysmacColumn column) { return row.cell(indexes[column]); };
  if (row.stray) {
    builder.report(kTextAfterQuote,
                   "text follows the closing quote of a cell and is left out; "
                   "write a quote inside a quoted cell as `\"\"`",
                   *row.stray);
  }
  if (cell(name).empty()) {
    if (row.blank()) return;
    builder.report(kRowWithoutIdentifier, "this row has no name and is left out; name the variable", row.whole);
    return;
  }
  ListRow& made = builder.add(row.whole, row.line);
  made.name = cell(name);
  made.vendor_address = cell(address_column);
  made.type = cell(datatype);
  made.comment = cell(comment);
  if (!cell(pou).empty()) builder.extra(made).scope = cell(pou);
}

std::optional<SymbolTable> read_sysmac(const Reading& reading) {
  TableBuilder builder(reading, address::Notation::omron);
  CsvReader rows(builder.text(), '\t', builder.table().arena);
  std::optional<SysmacIndexes> indexes;
  CsvRow row;
  while (rows.next(row)) {
    if (const auto found = sysmac_indexes_of(row)) {
      indexes = found;
    } else if (indexes) {
      add_sysmac_row(builder, row, *indexes);
    } else if (!row.blank()) {
      break;
    }
  }
  if (rows.unclosed_quote()) {
    builder.report(kUnclosedQuote, "this quote is never closed; close it or remove it",
                   {*rows.unclosed_quote(), *rows.unclosed_quote() + 1});
    return std::nullopt;
  }
  if (!indexes) {
    builder.report(kUnknownFormat,
                   "found no header `HOST NAME DATATYPE ADDRESS ...`, separated by TAB; export the global variables "
                   "for CX-Designer again",
                   builder.source().span_of(builder.source().line_at(0)));
    return std::nullopt;
  }
  return builder.finish();
}

}  // namespace

const ReaderInfo kSysmac{"sysmac", "Sysmac Studio global variables for CX-Designer", sysmac_likelihood, read_sysmac};

}  // namespace symplant::read
