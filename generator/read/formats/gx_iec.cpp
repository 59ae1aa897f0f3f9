// Reads global variable lists of GX IEC Developer 7 and of tools with the same columns (Panasonic FPWIN Pro).
#include "read/cells/table_reading.hpp"
#include "read/formats.hpp"
#include "read/rules/missing_column.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/rules/unknown_format.hpp"

namespace symplant::read {

namespace {

constexpr int kAsAnyTable = 30;  ///< a name and an address: the reader of any table looks at the cells, too

int gx_iec_likelihood(std::string_view text) {
  const LayoutSearch search = find_gx_layout(text);
  if (!search.layout) return search.nameless_header || search.unclosed_quote ? 10 : 0;
  if (!search.layout->header_line) return 50;
  const Columns& columns = search.layout->columns;
  if (columns.has(Field::vendor_address) && columns.has(Field::iec_address)) return 90;
  if (columns.has(Field::klass)) return 60;
  return columns.has_address() ? kAsAnyTable : 0;
}

void report_no_list(const Reading& reading, const LayoutSearch& search) {
  const auto report = [&](const diag::RuleInfo& rule, std::string message, text::Span where) {
    reading.diagnostics.add(rule, std::move(message), {reading.source, where});
  };
  if (search.unclosed_quote) {
    return report(kUnclosedQuote, "this quote is never closed; close it or remove it",
                  {*search.unclosed_quote, *search.unclosed_quote + 1});
  }
  if (search.nameless_header) {
    return report(kMissingColumn,
                  "this header has no column of identifiers; name a column `Identifier`, `Label Name`, "
                  "`Variable` or `Name`, or give the column with `--columns name=`",
                  *search.nameless_header);
  }
  report(kUnknownFormat,
         "found neither a header with a column of identifiers nor a class such as `VAR_GLOBAL`, so this is "
         "not a list of global variables; export one, or put a header above the rows",
         reading.source->span_of(reading.source->line_at(0)));
}

/// Class, Identifier, MIT-Addr., IEC-Addr., Type, Initial, Comment in any order, with or without a header; other
/// columns and lines before the header are ignored. The content of an address decides whether it is a MIT or an IEC
/// address, not the header.
std::optional<SymbolTable> read_gx_iec(const Reading& reading) {
  const LayoutSearch search = find_gx_layout(reading.source->text());
  if (!search.layout) {
    report_no_list(reading, search);
    return std::nullopt;
  }
  return read_table(reading, *search.layout, {.notation = address::Notation::melsec, .sort_addresses = true});
}

}  // namespace

const ReaderInfo kGxIec{"gx-iec", "GX IEC Developer 7 global variable list", gx_iec_likelihood, read_gx_iec};

}  // namespace symplant::read
