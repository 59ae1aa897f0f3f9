// Writes tag tables of TIA Portal as a workbook.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "convert/addresses.hpp"
#include "convert/formats.hpp"
#include "convert/losses.hpp"
#include "convert/names.hpp"
#include "convert/types.hpp"
#include "convert/workbook.hpp"
#include "convert/xml_text.hpp"
#include "model/classify.hpp"
#include "text/utf8.hpp"

namespace symplant::convert {
namespace {

constexpr Loss kNoInitialValue{"initial value is not written", "initial values are not written", "a tag has none"};
constexpr Loss kNoTagAddress{"tag has no address", "tags have no address",
                             "the list has no SIMATIC address for it; TIA Portal marks such a tag as faulty"};

constexpr std::array<std::string_view, 10> kTagColumns{
    "Name",        "Path",           "Data Type",     "Logical Address", "Comment",
    "Hmi Visible", "Hmi Accessible", "Hmi Writeable", "Typeobject ID",   "Version ID"};
constexpr std::array<std::string_view, 5> kConstantColumns{"Name", "Path", "Data Type", "Value", "Comment"};

class TagTable {
 public:
  explicit TagTable(const Writing& writing) : symbols_(*writing.symbols), report_(writing.report) {
    for (std::uint32_t i = 0; i < symbols_.all.size(); ++i) {
      if (tia_type(symbols_.all[i])) {
        written_.push_back(i);
      } else {
        report_.add(kUnknownType, symbols_.all[i].row->name);
      }
    }
    names_.emplace(symbols_, written_, kTiaNames, report_);
    for (const std::string_view column : kTagColumns) tags_.cells.push_back(strings_.add(column));
    for (const std::string_view column : kConstantColumns) constants_.cells.push_back(strings_.add(column));
    for (const std::uint32_t i : written_) counts_.add(symbols_.all[i]);
    for (const std::uint32_t i : written_) symbols_.all[i].kind == Kind::constant ? add_constant(i) : add_tag(i);
  }

  const Written& counts() const { return counts_; }

  base::Result<std::string, WriteError> bytes() {
    if (tags_.rows() > kMostSheetRows || constants_.rows() > kMostSheetRows) {
      return WriteError{"the list has " + std::to_string(tags_.rows() - 1) + " tags, but a sheet holds " +
                        std::to_string(kMostSheetRows - 1) + "; convert its parts one by one"};
    }
    std::vector<SheetTable> sheets;
    sheets.push_back(std::move(tags_));
    if (constants_.rows() > 1) sheets.push_back(std::move(constants_));
    return workbook_bytes(sheets, strings_);
  }

 private:
  void add_tag(std::uint32_t index) {
    const Symbol& symbol = symbols_.all[index];
    std::string address = address_in(symbol, kSiemensForm);
    if (address.empty() && source_address(symbol).starts_with('%') && is_siemens(symbol)) {
      address = source_address(symbol);  // a timer, a field of a data block
    }
    if (address.empty()) {
      report_.add(kNoTagAddress, symbol.row->name);
    } else if (is_bit_of_word(symbol)) {
      report_.add(kBitOfWord, symbol.row->name);
    }
    if (has_initial_value(symbol)) report_.add(kNoInitialValue, symbol.row->name);
    begin_row(tags_, index);
    tags_.cells.push_back(strings_.keep(std::move(address)));
    tags_.cells.push_back(comment(symbol));
    const std::uint32_t yes = strings_.add("True");
    const std::uint32_t nothing = strings_.add("");
    tags_.cells.insert(tags_.cells.end(), {yes, yes, yes, nothing, nothing});
  }

  void add_constant(std::uint32_t index) {
    const Symbol& symbol = symbols_.all[index];
    auto value = iec_literal(symbol.row->initial, iec_type(symbol).value_or(""));
    if (!value) report_.add(kUnknownInitial, symbol.row->name);
    begin_row(constants_, index);
    constants_.cells.push_back(strings_.keep(value.value_or("")));
    constants_.cells.push_back(comment(symbol));
  }

  void begin_row(SheetTable& sheet, std::uint32_t index) {
    const Symbol& symbol = symbols_.all[index];
    const std::string_view scope = symbol.extra->scope;
    sheet.cells.push_back(strings_.add((*names_)[index]));
    sheet.cells.push_back(strings_.add(scope.empty() ? kDefaultTagTable : scope));
    sheet.cells.push_back(strings_.keep(*tia_type(symbol)));
  }

  static bool is_siemens(const Symbol& symbol) { return symbol.notation == address::Notation::siemens; }

  /// Whether the row gives a value other than the default of the type.
  static bool has_initial_value(const Symbol& symbol) {
    const auto type = model::data_type(iec_type(symbol).value_or(""));
    if (!type) return !symbol.row->initial.empty();
    return model::initial_value(symbol.row->initial, *type) != std::uint64_t{0};
  }

  std::uint32_t comment(const Symbol& symbol) {
    const std::string_view whole = symbol.row->comment;
    const std::string_view text = text::first_code_points(whole, kMostCellCharacters);
    if (text.size() != whole.size() || !is_xml_text(text)) report_.add(kCommentChanged, symbol.row->name);
    return strings_.add(text);
  }

  const Symbols& symbols_;
  Report& report_;
  std::vector<std::uint32_t> written_;
  Written counts_;
  std::optional<Names> names_;
  SharedStrings strings_;
  SheetTable tags_{"PLC Tags", kTagColumns.size(), {}};
  SheetTable constants_{"Constants", kConstantColumns.size(), {}};
};

base::Result<Output, WriteError> write_tia_xlsx(const Writing& writing) {
  TagTable table(writing);
  auto bytes = table.bytes();
  if (!bytes) return bytes.error();
  return Output{base::whole(std::move(*bytes)), table.counts()};
}

}  // namespace

const WriterInfo kTiaXlsxWriter{"tia-xlsx",    "tag tables of TIA Portal as a workbook", ".xlsx", false, false,
                                write_tia_xlsx};

}  // namespace symplant::convert
