// Reads PLC tag tables of TIA Portal in quoted cells (.sdf).
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/table_builder.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

// The cells: name, address, type, visible and accessible for an HMI, retentive, comment, an unused one, writable.
constexpr std::size_t kTiaCellsBeforeComment = 6;
constexpr std::size_t kTiaCellsAfterComment = 2;
constexpr std::array<std::size_t, 4> kTiaSwitches{3, 4, 5, 8};

bool is_tia_switch(std::string_view cell) {
  return text::equal_ignoring_case(cell, "True") || text::equal_ignoring_case(cell, "False");
}

bool split_tia(std::string_view line, std::vector<std::string_view>& cells) {
  return split_quoted(line, kTiaCellsBeforeComment, kTiaCellsAfterComment, cells) &&
         std::all_of(kTiaSwitches.begin(), kTiaSwitches.end(), [&](std::size_t i) { return is_tia_switch(cells[i]); });
}

int tia_sdf_likelihood(std::string_view text) {
  LineReader lines(text);
  Line line;
  while (lines.next(line)) {
    if (without_blanks(line.text).empty()) continue;
    std::vector<std::string_view> cells;
    return split_tia(line.text, cells) && (cells[1].empty() || cells[1].front() == '%') ? 95 : 0;
  }
  return 0;
}

std::optional<SymbolTable> read_tia_sdf(const Reading& reading) {
  TableBuilder builder(reading, address::Notation::siemens);
  LineReader lines(builder.text());
  Line line;
  std::vector<std::string_view> cells;
  while (lines.next(line)) {
    if (without_blanks(line.text).empty()) continue;
    if (!split_tia(line.text, cells)) {
      builder.report(kRowNotUnderstood,
                     "this line does not have the nine quoted cells of a tag and is left out; export the tags again",
                     line.span());
      continue;
    }
    for (std::string_view& cell : cells) cell = without_blanks(cell);
    if (cells[0].empty()) {
      builder.report(kRowWithoutIdentifier, "this row has no name and is left out; name the tag", line.span());
      continue;
    }
    ListRow& row = builder.add(line.span(), line.number);
    row.name = cells[0];
    row.vendor_address = cells[1];
    row.type = cells[2];
    row.comment = cells[kTiaCellsBeforeComment];
  }
  return builder.finish();
}

}  // namespace

const ReaderInfo kTiaSdf{"tia-sdf", "TIA Portal PLC tags (.sdf)", tia_sdf_likelihood, read_tia_sdf};

}  // namespace symplant::read
