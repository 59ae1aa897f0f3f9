// Reads device comments of GX Works2, GX Works3 and GX Developer: addresses and comments, no names.
#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "address/notation.hpp"
#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array kGxWorksCommentsHeaders{
    HeaderWords{"device", "devicecomment"}, HeaderWords{"devicename", "comment"},
    HeaderWords{"デバイス名", "コメント"},  HeaderWords{"디바이스명", "코멘트"},
    HeaderWords{"软元件名", "注释"},        HeaderWords{"device", "label", "comment"},
    HeaderWords{"device", "comment"}};

/// Whether nearly all cells of the address column are addresses of MELSEC.
bool holds_addresses(std::string_view text, const Layout& layout) {
  std::deque<std::string> arena;
  const std::vector<CsvRow> rows = sample_rows(text, layout, arena);
  const auto cells = sample_cells(rows, layout.columns[Field::vendor_address]);
  const auto addresses = std::count_if(cells.begin(), cells.end(), [](std::string_view cell) {
    return address::address_strength(cell) > 0 && address::parse(cell, {address::Notation::melsec}).has_value();
  });
  return !cells.empty() && static_cast<std::size_t>(addresses) * 10 >= cells.size() * 9;
}

/// Other lists have a device and a comment, too: with more than three columns, none may be one of names, and the cells
/// decide.
std::optional<Layout> gx_works_comments_layout(std::string_view text) {
  auto layout = layout_in_any(text, kGxWorksCommentsHeaders);
  if (!layout) return std::nullopt;
  while (!layout->header.empty() && layout->header.back().empty()) layout->header.pop_back();
  if (!layout->columns.has(Field::vendor_address)) layout->columns.set(Field::vendor_address, 0);
  const bool is_plain = layout->header.size() <= 3;
  if (!is_plain && (layout->columns.has(Field::name) || !holds_addresses(text, *layout))) return std::nullopt;
  return layout;
}

int gx_works_comments_likelihood(std::string_view text) { return gx_works_comments_layout(text) ? kKnownHeader : 0; }

std::optional<SymbolTable> read_gx_works_comments(const Reading& reading) {
  const auto layout = gx_works_comments_layout(reading.source->text());
  if (!layout) return kAnyTable.read(reading);
  return read_table(reading, *layout, {.notation = address::Notation::melsec, .address_for_name = true});
}

}  // namespace

const ReaderInfo kGxWorksComments{"gx-works-comments", "GX Works device comments", gx_works_comments_likelihood,
                                  read_gx_works_comments};

}  // namespace symplant::read
