// Reads PLC tag tables that TIA Portal exports by Openness or the version control interface.
#include <string>

#include "read/formats.hpp"
#include "read/line_counter.hpp"
#include "read/rules/header_alone.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/table_builder.hpp"
#include "read/xml/cells.hpp"
#include "read/xml/prolog.hpp"

namespace symplant::read {

namespace {

/// The text of a comment: the first one that is not empty in a language other than English, else in English.
xml::Element comment_text(const xml::Element& tag) {
  xml::Element text = tag.child("ObjectList").child("MultilingualText");
  while (text && text.attribute("CompositionName").text != "Comment") text = text.next_sibling();
  xml::Element english;
  std::string joined;
  for (xml::Element item = text.child("ObjectList").first_child(); item; item = item.next_sibling()) {
    const xml::Element attributes = item.child("AttributeList");
    const xml::Element content = attributes.child("Text");
    if (content.content(joined).text.find_first_not_of(" \t\r\n") == std::string_view::npos) continue;
    if (!attributes.child("Culture").content(joined).text.starts_with("en")) return content;
    if (!english) english = content;
  }
  return english;
}

class OpennessReading {
 public:
  explicit OpennessReading(const Reading& reading)
      : builder_(reading, address::Notation::siemens), lines_(builder_.text()) {}

  std::optional<SymbolTable> read(const xml::Document& document) {
    xml::Walk walk(document.root());
    while (const xml::Element element = walk.next()) {
      const std::string_view name = element.name();
      if (name == "SW.Tags.PlcTagTable") {
        ++tables_;
        scope_ = builder_.extra_for_scope(xml::content_cell(builder_, element.child("AttributeList").child("Name")));
      } else if (name == "SW.Tags.PlcTag") {
        take_tag(element, false);
        walk.skip_content();
      } else if (name == "SW.Tags.PlcUserConstant" || name == "SW.Tags.PlcSystemConstant") {
        take_tag(element, true);
        walk.skip_content();
      }
    }
    if (builder_.table().rows.empty()) return refuse();
    builder_.decide("tables: " + std::to_string(tables_) + ", with " + std::to_string(constants_) + " constants");
    return builder_.finish();
  }

 private:
  std::optional<SymbolTable> refuse() {
    builder_.report(kHeaderAlone,
                    tables_ == 0 ? "the file has no PLC tags; export the PLC tag tables instead of blocks or types"
                                 : "the tag table is empty; export the tag tables that have the inputs and outputs",
                    builder_.source().span_of(builder_.source().line_at(0)));
    return std::nullopt;
  }

  void take_tag(const xml::Element& tag, bool is_constant) {
    const text::Span whole = tag.tag();
    const xml::Element attributes = tag.child("AttributeList");
    const auto cell = [&](std::string_view name) { return xml::content_cell(builder_, attributes.child(name)); };
    const std::string_view name = cell("Name");
    if (name.empty()) {
      builder_.report(kRowWithoutIdentifier, "this tag has no name and is left out; give it one", whole);
      return;
    }
    ListRow& row = builder_.add(whole, lines_.line_at(whole.begin));
    row.name = name;
    row.type = cell("DataTypeName");
    row.comment = xml::content_cell(builder_, comment_text(tag));
    if (is_constant) {
      ++constants_;
      row.klass = "VAR_GLOBAL_CONSTANT";
      row.initial = cell("Value");
    } else {
      row.vendor_address = cell("LogicalAddress");
    }
    row.extra = scope_;
  }

  TableBuilder builder_;
  LineCounter lines_;
  std::uint32_t scope_ = kNoExtra;  ///< the extra of the rows of the table
  std::size_t tables_ = 0;
  std::size_t constants_ = 0;
};

int tia_openness_likelihood(std::string_view text) {
  const xml::Prolog prolog = xml::read_prolog(text);
  if (prolog.root != "Document") return 0;
  if (prolog.head.find("<SW.Tags.") != std::string_view::npos) return 95;
  return prolog.head.find("<SW.") != std::string_view::npos ? 60 : 0;
}

std::optional<SymbolTable> read_tia_openness(const Reading& reading) {
  const auto document = xml::Document::parse(reading);
  if (!document) return std::nullopt;
  return OpennessReading(reading).read(*document);
}

}  // namespace

const ReaderInfo kTiaOpenness{"tia-openness", "TIA Portal PLC tags (Openness XML)", tia_openness_likelihood,
                              read_tia_openness};

}  // namespace symplant::read
