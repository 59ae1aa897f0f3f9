// Reads symbol tables of STEP 7 in fixed columns (.asc).
#include <optional>
#include <string>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/step7_rows.hpp"

namespace symplant::read {

namespace {

constexpr std::string_view kAscBegin = "126,";
constexpr std::size_t kAscNameColumns = 24;
constexpr std::size_t kAscAddressColumns = 12;
constexpr std::size_t kAscTypeColumns = 10;

int step7_asc_likelihood(std::string_view text) {
  LineReader lines(text);
  Line line;
  while (lines.next(line)) {
    if (!without_blanks(line.text).empty()) return line.text.starts_with(kAscBegin) ? 95 : 0;
  }
  return 0;
}

std::optional<SymbolTable> read_step7_asc(const Reading& reading) {
  TableBuilder builder(reading, address::Notation::siemens);
  LineReader lines(builder.text());
  Line line;
  while (lines.next(line)) {
    if (without_blanks(line.text).empty()) continue;
    if (!line.text.starts_with(kAscBegin)) {
      builder.report(kRowNotUnderstood,
                     "this line does not begin with `126,` and is left out; export the symbol table again",
                     line.span());
      continue;
    }
    std::string_view rest = line.text.substr(kAscBegin.size());
    const std::string_view name = cut_columns(rest, kAscNameColumns);
    const std::string_view address = cut_columns(rest, kAscAddressColumns);
    const std::string_view type = cut_columns(rest, kAscTypeColumns);
    add_step7_row(builder, line, {name, address, type, without_blanks(rest)});
  }
  return builder.finish();
}

}  // namespace

const ReaderInfo kStep7Asc{"step7-asc", "STEP 7 symbol table (.asc)", step7_asc_likelihood, read_step7_asc};

}  // namespace symplant::read
