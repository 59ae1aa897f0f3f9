// Rows of the symbol tables of STEP 7.
#include "read/step7_rows.hpp"

#include "read/cells/padded.hpp"
#include "read/rules/row_without_identifier.hpp"

namespace symplant::read {

namespace {

/// The cell with one blank between its parts.
std::string_view with_one_blank(TableBuilder& builder, std::string_view cell) {
  return cell.find("  ") == std::string_view::npos ? cell : builder.keep(squeezed(cell));
}

}  // namespace

void add_step7_row(TableBuilder& builder, const Line& line, const Step7Cells& cells) {
  if (cells.name.empty()) {
    builder.report(kRowWithoutIdentifier, "this row has no symbol and is left out; give its address a symbol",
                   line.span());
    return;
  }
  ListRow& row = builder.add(line.span(), line.number);
  row.name = cells.name;
  row.vendor_address = with_one_blank(builder, cells.address);
  row.type = with_one_blank(builder, cells.type);
  row.comment = cells.comment;
}

}  // namespace symplant::read
