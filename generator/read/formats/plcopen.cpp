// Reads projects in PLCopen XML (TC6), of OpenPLC, Beremiz, CODESYS and others.
#include <array>
#include <string>
#include <unordered_set>

#include "read/formats.hpp"
#include "read/line_counter.hpp"
#include "read/rules/header_alone.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/table_builder.hpp"
#include "read/unique_names.hpp"
#include "read/xml/cells.hpp"
#include "read/xml/plcopen_type.hpp"
#include "read/xml/prolog.hpp"

namespace symplant::read {

namespace {

constexpr std::string_view kGlobalVars = "globalVars";

/// The lists of variables; all others (externalVars, accessVars) declare none.
struct PlcopenList {
  std::string_view element;
  std::string_view klass;
};
constexpr std::array kPlcopenLists{
    PlcopenList{"localVars", "VAR"},         PlcopenList{"tempVars", "VAR_TEMP"},
    PlcopenList{"inputVars", "VAR_INPUT"},   PlcopenList{"outputVars", "VAR_OUTPUT"},
    PlcopenList{"inOutVars", "VAR_IN_OUT"},  PlcopenList{kGlobalVars, "VAR_GLOBAL"},
    PlcopenList{"configVars", "VAR_CONFIG"},
};

const PlcopenList* plcopen_list(std::string_view element) {
  for (const PlcopenList& list : kPlcopenLists) {
    if (list.element == element) return &list;
  }
  return nullptr;
}

/// Whether an element holds code or types: no variable of the project is in it.
bool is_without_variables(std::string_view element) {
  return element == "body" || element == "dataTypes" || element == "variable" || element == "actions" ||
         element == "transitions" || element == "coordinateInfo";
}

/// The nearest element around a list that has a name: a program, a function block, a resource. Looks at 64 at most, so
/// that lists in lists take no time.
xml::Element named_parent(xml::Element list) {
  for (int level = 0; list && level < 64; ++level) {
    const std::size_t length = list.attribute("name").text.size();
    if (list.name() != "data" && length > 0 && length < 256) return list;
    list = list.parent();
  }
  return {};
}

class PlcopenReading {
 public:
  explicit PlcopenReading(const Reading& reading)
      : builder_(reading, address::Notation::iec), lines_(builder_.text()) {}

  std::optional<SymbolTable> read(const xml::Document& document) {
    xml::Walk walk(document.root());
    while (const xml::Element element = walk.next()) {
      if (const PlcopenList* list = plcopen_list(element.name())) take_list(element, *list);
      if (is_without_variables(element.name())) walk.skip_content();
    }
    if (builder_.table().rows.empty()) return refuse();
    builder_.decide("variables: " + std::to_string(builder_.table().rows.size()) + " global or with an address (" +
                    std::to_string(located_) + " with one), " + std::to_string(locals_) +
                    " local ones without an address left out");
    qualify_repeated_names(builder_);
    return builder_.finish();
  }

 private:
  std::optional<SymbolTable> refuse() {
    builder_.report(kHeaderAlone,
                    "the project has " + std::to_string(locals_) +
                        " local variables, but none with an address and no global one; give the inputs and outputs "
                        "addresses, or export the lists of global variables too",
                    builder_.source().span_of(builder_.source().line_at(0)));
    return std::nullopt;
  }

  void take_list(const xml::Element& element, const PlcopenList& list) {
    const bool is_global = list.element == kGlobalVars;
    // CODESYS writes a list with blocks of several classes twice: as a whole, and block by block in this element.
    const bool is_part = element.parent().name() == "MixedAttrsVarList";
    if (is_global && !is_part) names_of_list_.clear();
    klass_ = list.klass;
    if (element.attribute("constant").text == "true") klass_ += "_CONSTANT";
    if (element.attribute("retain").text == "true") klass_ += "_RETAIN";
    scope_ = builder_.extra_for_scope(xml::attribute_cell(builder_, named_parent(element), "name"));
    kept_klass_ = klass_ == list.klass ? list.klass : builder_.keep(klass_);
    for (xml::Element variable = element.first_child(); variable; variable = variable.next_sibling()) {
      if (variable.name() == "variable" || variable.name() == "configVariable") take(variable, is_global, is_part);
    }
  }

  void take(const xml::Element& variable, bool is_global, bool is_part) {
    const std::string_view address = xml::attribute_cell(builder_, variable, "address");
    if (!is_global && address.empty()) {
      ++locals_;
      return;
    }
    const text::Span whole = variable.tag();
    const bool is_path = variable.name() == "configVariable";
    const std::string_view name = xml::attribute_cell(builder_, variable, is_path ? "instancePathAndName" : "name");
    if (name.empty()) {
      builder_.report(kRowWithoutIdentifier, "this variable has no name and is left out; give it one", whole);
      return;
    }
    if (is_global && !names_of_list_.insert(name).second && is_part) return;
    if (!address.empty()) ++located_;
    ListRow& row = builder_.add(whole, lines_.line_at(whole.begin));
    row.klass = kept_klass_;
    row.name = name;
    row.vendor_address = address;
    row.type = kept_type(xml::plcopen_type(variable.child("type")));
    row.initial = xml::attribute_cell(builder_, variable.child("initialValue").child("simpleValue"), "value");
    row.comment = xml::content_cell(builder_, variable.child("documentation"));
    row.extra = scope_;
  }

  /// The type in the table's memory, each once.
  std::string_view kept_type(std::string type) {
    const auto found = types_.find(type);
    return found != types_.end() ? *found : *types_.insert(builder_.keep(std::move(type))).first;
  }

  TableBuilder builder_;
  LineCounter lines_;
  std::string klass_;
  std::string_view kept_klass_;
  std::uint32_t scope_ = kNoExtra;                      ///< the extra of the rows of the list
  std::unordered_set<std::string_view> names_of_list_;  ///< of the last list of global variables
  std::unordered_set<std::string_view> types_;
  std::size_t located_ = 0;
  std::size_t locals_ = 0;
};

int plcopen_likelihood(std::string_view text) {
  const xml::Prolog prolog = xml::read_prolog(text);
  if (prolog.root != "project") return 0;
  return prolog.head.substr(0, 4096).find("plcopen.org/xml/tc6") != std::string_view::npos ? 95 : 0;
}

std::optional<SymbolTable> read_plcopen(const Reading& reading) {
  const auto document = xml::Document::parse(reading);
  if (!document) return std::nullopt;
  return PlcopenReading(reading).read(*document);
}

}  // namespace

const ReaderInfo kPlcopen{"plcopen", "PLCopen XML (TC6)", plcopen_likelihood, read_plcopen};

}  // namespace symplant::read
