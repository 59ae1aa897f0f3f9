// Reads variables of EcoStruxure Control Expert (Unity Pro): exchange files with a `dataBlock`.
#include <string>

#include "read/formats.hpp"
#include "read/line_counter.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/table_builder.hpp"
#include "read/xml/cells.hpp"
#include "read/xml/prolog.hpp"

namespace symplant::read {

namespace {

class XsyReading {
 public:
  explicit XsyReading(const Reading& reading) : builder_(reading, address::Notation::iec), lines_(builder_.text()) {}

  std::optional<SymbolTable> read(const xml::Document& document) {
    for (xml::Element block = document.root().first_child(); block; block = block.next_sibling()) {
      if (block.name() != "dataBlock") continue;
      for (xml::Element variable = block.first_child(); variable; variable = variable.next_sibling()) {
        if (variable.name() == "variables") take(variable);
      }
    }
    builder_.decide("variables: " + std::to_string(builder_.table().rows.size()) + ", " + std::to_string(located_) +
                    " of them with an address");
    return builder_.finish();
  }

 private:
  void take(const xml::Element& variable) {
    const text::Span whole = variable.tag();
    const std::string_view name = xml::attribute_cell(builder_, variable, "name");
    if (name.empty()) {
      builder_.report(kRowWithoutIdentifier, "this variable has no name and is left out; give it one", whole);
      return;
    }
    ListRow& row = builder_.add(whole, lines_.line_at(whole.begin));
    row.name = name;
    row.vendor_address = xml::attribute_cell(builder_, variable, "topologicalAddress");
    row.type = xml::attribute_cell(builder_, variable, "typeName");
    if (row.type == "EBOOL") row.type = "BOOL";  // a BOOL with edges and forcing
    row.initial = xml::attribute_cell(builder_, variable.child("variableInit"), "value");
    row.comment = xml::content_cell(builder_, variable.child("comment"));
    if (!row.vendor_address.empty()) ++located_;
  }

  TableBuilder builder_;
  LineCounter lines_;
  std::size_t located_ = 0;
};

int schneider_xsy_likelihood(std::string_view text) {
  const xml::Prolog prolog = xml::read_prolog(text);
  if (prolog.root == "VariablesExchangeFile") return 95;
  const bool other_export =
      prolog.root.ends_with("ExchangeFile") && prolog.head.find("Schneider") != std::string_view::npos;
  return other_export ? 80 : 0;
}

std::optional<SymbolTable> read_schneider_xsy(const Reading& reading) {
  const auto document = xml::Document::parse(reading);
  if (!document) return std::nullopt;
  return XsyReading(reading).read(*document);
}

}  // namespace

const ReaderInfo kSchneiderXsy{"schneider-xsy", "Control Expert (Unity Pro) variables", schneider_xsy_likelihood,
                               read_schneider_xsy};

}  // namespace symplant::read
