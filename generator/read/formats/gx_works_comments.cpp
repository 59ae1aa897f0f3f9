// Reads device comments of GX Works2, GX Works3 and GX Developer: addresses and comments, no names.
#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array kGxWorksCommentsHeaders{
    HeaderWords{"devicename", "comment"},      HeaderWords{"デバイス名", "コメント"},
    HeaderWords{"디바이스명", "코멘트"},       HeaderWords{"软元件名", "注释"},
    HeaderWords{"device", "label", "comment"}, HeaderWords{"device", "comment"}};

/// With up to three columns: other lists have a device and a comment, too.
std::optional<Layout> gx_works_comments_layout(std::string_view text) {
  auto layout = layout_in_any(text, kGxWorksCommentsHeaders);
  if (!layout) return std::nullopt;
  while (!layout->header.empty() && layout->header.back().empty()) layout->header.pop_back();
  if (layout->header.size() > 3) return std::nullopt;
  if (!layout->columns.has(Field::vendor_address)) layout->columns.set(Field::vendor_address, 0);
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
