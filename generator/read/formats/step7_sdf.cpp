// Reads symbol tables of STEP 7 in quoted cells (.sdf).
#include <optional>
#include <string>
#include <vector>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/step7_rows.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kStep7CellsBeforeComment = 3;
constexpr std::size_t kSdfAddressColumns = 12;
constexpr std::size_t kSdfTypeColumns = 10;

int step7_sdf_likelihood(std::string_view text) {
  LineReader lines(text);
  Line line;
  while (lines.next(line)) {
    if (without_blanks(line.text).empty()) continue;
    std::vector<std::string_view> cells;
    const bool padded = split_quoted(line.text, kStep7CellsBeforeComment, 0, cells) &&
                        cells[1].size() == kSdfAddressColumns && cells[2].size() == kSdfTypeColumns;
    return padded ? 95 : 0;
  }
  return 0;
}

std::optional<SymbolTable> read_step7_sdf(const Reading& reading) {
  TableBuilder builder(reading, address::Notation::siemens);
  LineReader lines(builder.text());
  Line line;
  std::vector<std::string_view> cells;
  while (lines.next(line)) {
    if (without_blanks(line.text).empty()) continue;
    if (!split_quoted(line.text, kStep7CellsBeforeComment, 0, cells)) {
      builder.report(kRowNotUnderstood,
                     "this line does not have four cells in quotes and is left out; export the symbol table again",
                     line.span());
      continue;
    }
    for (std::string_view& cell : cells) cell = without_blanks(cell);
    add_step7_row(builder, line, {cells[0], cells[1], cells[2], cells[3]});
  }
  return builder.finish();
}

}  // namespace

const ReaderInfo kStep7Sdf{"step7-sdf", "STEP 7 symbol table (.sdf)", step7_sdf_likelihood, read_step7_sdf};

}  // namespace symplant::read
