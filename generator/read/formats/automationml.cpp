// Reads PLC tags of AutomationML files (CAEX 2.15 and 3.0) by the recommendation "Automation Project Configuration", as
// TIA Portal, EPLAN and PLCnext Engineer exchange them.
#include <fmt/format.h>

#include <string>

#include "read/formats.hpp"
#include "read/line_counter.hpp"
#include "read/rules/header_alone.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/table_builder.hpp"
#include "read/types/data_types.hpp"
#include "read/xml/cells.hpp"
#include "read/xml/prolog.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

/// The name of a class at the end of a path, as in `AutomationProjectConfigurationInterfaceClassLib/Tag`.
std::string_view class_of(std::string_view path) { return path.substr(path.rfind('/') + 1); }

bool has_role(const xml::Element& element, std::string_view role) {
  for (xml::Element child = element.first_child(); child; child = child.next_sibling()) {
    const std::string_view path = child.name() == "SupportedRoleClass" ? child.attribute("RefRoleClassPath").text
                                  : child.name() == "RoleRequirements" ? child.attribute("RefBaseRoleClassPath").text
                                                                       : std::string_view();
    if (!path.empty() && class_of(path) == role) return true;
  }
  return false;
}

/// The PLC: the first element around a tag that is neither its table nor a folder of tables.
xml::Element plc_of(xml::Element table) {
  while (has_role(table, "TagTable") || has_role(table, "TagUserFolder")) table = table.parent();
  return table;
}

/// The value of an attribute, which CAEX writes as an element. If it is empty, the first one of the attributes in it:
/// texts in several languages are there.
xml::Element value_of(const xml::Element& tag, std::string_view name) {
  xml::Element attribute = tag.child("Attribute");
  while (attribute && (attribute.name() != "Attribute" || attribute.attribute("Name").text != name)) {
    attribute = attribute.next_sibling();
  }
  std::string joined;
  const auto is_filled = [&](const xml::Element& value) { return value && !value.content(joined).text.empty(); };
  if (is_filled(attribute.child("Value"))) return attribute.child("Value");
  for (xml::Element inner = attribute.first_child(); inner; inner = inner.next_sibling()) {
    const bool is_text = inner.attribute("Name").text.starts_with("aml-lang");
    if (is_text && is_filled(inner.child("Value"))) return inner.child("Value");
  }
  return {};
}

/// A Siemens address of the area `%I` or `%Q` for a number without a bit: a structure begins at a bit, as a BOOL does.
std::string sized_address(std::string_view area, std::string_view number, std::string_view type) {
  const std::optional<tables::DataType> known = data_type(type);
  const auto is_of = [&](std::string_view other) { return text::equal_ignoring_case(type, other); };
  const bool is_word = is_of("DATE") || is_of("S5TIME");
  const bool is_double_word = is_of("TIME") || is_of("TOD") || is_of("TIME_OF_DAY");
  const int bits = known ? data_type_bits(*known) : is_word ? 16 : is_double_word ? 32 : 1;
  if (bits == 1) return fmt::format("{}{}.0", area, number);
  return fmt::format("{}{}{}", area, bits == 8 ? 'B' : bits == 16 ? 'W' : 'D', number);
}

class AutomationMlReading {
 public:
  explicit AutomationMlReading(const Reading& reading)
      : builder_(reading, address::Notation::siemens), lines_(builder_.text()) {}

  std::optional<SymbolTable> read(const xml::Document& document) {
    xml::Walk walk(document.root());
    while (const xml::Element element = walk.next()) {
      if (element.name() != "ExternalInterface") continue;
      const std::string_view of = class_of(element.attribute("RefBaseClassPath").text);
      if (of == "Tag") take_tag(element);
      if (of == "Channel") ++channels_;
      walk.skip_content();
    }
    if (builder_.table().rows.empty()) {
      builder_.report(kHeaderAlone,
                      channels_ == 0 ? "the file has no PLC tags; export the project with its PLC tag tables"
                                     : "the file has channels of modules, but no PLC tags; export the PLC tags, too",
                      builder_.source().span_of(builder_.source().line_at(0)));
      return std::nullopt;
    }
    builder_.decide(fmt::format("tag tables: {}, of {} PLC{}", tables_, plcs_, plcs_ == 1 ? "" : "s"));
    return builder_.finish();
  }

 private:
  void enter(const xml::Element& table) {
    table_ = table;
    ++tables_;
    scope_ = builder_.extra_for_scope(xml::attribute_cell(builder_, table, "Name"));
    const xml::Element plc = plc_of(table);
    if (plc == plc_) return;
    plc_ = plc;
    if (plcs_++ != 0) builder_.begin_part();
  }

  void take_tag(const xml::Element& tag) {
    const text::Span whole = tag.tag();
    const std::string_view name = xml::attribute_cell(builder_, tag, "Name");
    if (name.empty()) {
      builder_.report(kRowWithoutIdentifier, "this tag has no name and is left out; give it one", whole);
      return;
    }
    if (tag.parent() != table_) enter(tag.parent());
    const auto cell = [&](std::string_view attribute) { return xml::content_cell(builder_, value_of(tag, attribute)); };
    ListRow& row = builder_.add(whole, lines_.line_at(whole.begin));
    row.name = name;
    row.type = cell("DataType");
    row.comment = cell("Comment");
    row.vendor_address = address_of(cell("LogicalAddress"), cell("IoType"), row.type);
    row.extra = scope_;
  }

  /// `0.0` of an input is `%I0.0`: the recommendation gives the direction apart. Some tools write whole addresses.
  std::string_view address_of(std::string_view number, std::string_view io, std::string_view type) {
    if (number.empty() || !text::is_digit(number.front())) return number;
    const bool input = text::equal_ignoring_case(io, "Input");
    if (!input && !text::equal_ignoring_case(io, "Output")) return number;
    const std::string_view area = input ? "%I" : "%Q";
    if (number.find('.') != std::string_view::npos) return builder_.keep(fmt::format("{}{}", area, number));
    return builder_.keep(sized_address(area, number, type));
  }

  TableBuilder builder_;
  LineCounter lines_;
  xml::Element table_;              ///< of the tags before
  xml::Element plc_;                ///< that has it
  std::uint32_t scope_ = kNoExtra;  ///< the extra of the rows of the table
  std::size_t tables_ = 0;
  std::size_t plcs_ = 0;
  std::size_t channels_ = 0;
};

int automationml_likelihood(std::string_view text) { return xml::read_prolog(text).root == "CAEXFile" ? 95 : 0; }

std::optional<SymbolTable> read_automationml(const Reading& reading) {
  const auto document = xml::Document::parse(reading);
  if (!document) return std::nullopt;
  return AutomationMlReading(reading).read(*document);
}

}  // namespace

const ReaderInfo kAutomationMl{"automationml", "AutomationML project (CAEX)", automationml_likelihood,
                               read_automationml};

}  // namespace symplant::read
