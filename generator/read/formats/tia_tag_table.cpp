// Reads PLC tag tables of TIA Portal in XML (`Tagtable`).
#include <algorithm>

#include "read/formats.hpp"
#include "read/line_counter.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/table_builder.hpp"
#include "read/xml/cells.hpp"
#include "read/xml/prolog.hpp"

namespace symplant::read {

namespace {

class TagTableReading {
 public:
  explicit TagTableReading(const Reading& reading)
      : builder_(reading, address::Notation::siemens), lines_(builder_.text()) {}

  std::optional<SymbolTable> read(const xml::Document& document) {
    if (document.root().name() == "Tagtable") take_table(document.root());
    xml::Walk walk(document.root());
    while (const xml::Element element = walk.next()) {
      if (element.name() == "Tagtable") take_table(element);
      if (element.name() == "Tag" || element.name() == "Constant") {
        take_tag(element, element.name() == "Constant");
        walk.skip_content();
      }
    }
    builder_.decide("tables: " + std::to_string(tables_) + ", with " + std::to_string(constants_) + " constants");
    return builder_.finish();
  }

 private:
  void take_table(const xml::Element& table) {
    ++tables_;
    scope_ = builder_.extra_for_scope(xml::attribute_cell(builder_, table, "name"));
  }

  void take_tag(const xml::Element& tag, bool is_constant) {
    const text::Span whole = tag.tag();
    const std::string_view name = xml::content_cell(builder_, tag);
    if (name.empty()) {
      builder_.report(kRowWithoutIdentifier, "this tag has no name and is left out; give it one", whole);
      return;
    }
    ListRow& row = builder_.add(whole, lines_.line_at(whole.begin));
    row.name = name;
    row.type = xml::attribute_cell(builder_, tag, "type");
    row.comment = xml::attribute_cell(builder_, tag, "remark");
    if (is_constant) {
      ++constants_;
      row.klass = "VAR_GLOBAL_CONSTANT";
      row.initial = xml::attribute_cell(builder_, tag, "value");
    } else {
      row.vendor_address = xml::attribute_cell(builder_, tag, "addr");
    }
    row.extra = scope_;
  }

  TableBuilder builder_;
  LineCounter lines_;
  std::uint32_t scope_ = kNoExtra;  ///< the extra of the rows of the table
  std::size_t tables_ = 0;
  std::size_t constants_ = 0;
};

int tia_tag_table_likelihood(std::string_view text) {
  const std::string_view root = xml::read_prolog(text).root;
  return root == "Tagtable" || root == "Tagtables" ? 95 : 0;
}

std::optional<SymbolTable> read_tia_tag_table(const Reading& reading) {
  const auto document = xml::Document::parse(reading);
  if (!document) return std::nullopt;
  return TagTableReading(reading).read(*document);
}

}  // namespace

const ReaderInfo kTiaTagTable{"tia-tag-table", "TIA Portal PLC tag table (XML)", tia_tag_table_likelihood,
                              read_tia_tag_table};

}  // namespace symplant::read
