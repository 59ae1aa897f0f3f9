// Reads projects and parts of projects of Logix Designer in XML (L5X).
#include <algorithm>
#include <array>
#include <string>

#include "read/formats.hpp"
#include "read/line_counter.hpp"
#include "read/rockwell/tags.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/xml/cells.hpp"
#include "read/xml/prolog.hpp"

namespace symplant::read {

namespace {

/// The tags that a module's connections have, and the ends of their names if the connection does not give them.
struct ModuleTag {
  std::string_view element;
  const char* suffix_attribute;
  std::string_view suffix;
};
constexpr std::array kModuleTags{
    ModuleTag{"InputTag", "InputTagSuffix", "I"},
    ModuleTag{"OutputTag", "OutputTagSuffix", "O"},
    ModuleTag{"InAliasTag", "InputTagSuffix", "I"},
    ModuleTag{"OutAliasTag", "OutputTagSuffix", "O"},
};

/// The begin of the names of a module's tags: `Local:3` and `Rack:3` on a backplane, the module's name on a network.
std::string module_path(const xml::Element& module) {
  constexpr std::array<std::string_view, 5> kNetworks{"Ethernet", "ControlNet", "DeviceNet", "RIO", "DHRIO"};
  xml::Element port = module.child("Ports").first_child();
  while (port && port.attribute("Upstream").text != "true") port = port.next_sibling();
  const std::string_view type = port.attribute("Type").text;
  const std::string_view address = port.attribute("Address").text;
  const bool on_network = std::any_of(kNetworks.begin(), kNetworks.end(), [&](std::string_view network) {
    return text::equal_ignoring_case(network, type);
  });
  if (!port || on_network || address.empty()) return std::string(module.attribute("Name").text);
  return std::string(module.attribute("ParentModule").text).append(":").append(address);
}

/// The element with the text of a description or comment: itself, or the first language that is not empty.
xml::Element text_element(const xml::Element& description) {
  std::string joined;
  for (xml::Element language = description.first_child(); language; language = language.next_sibling()) {
    if (language.content(joined).text.find_first_not_of(" \t\r\n") != std::string_view::npos) return language;
  }
  return description;
}

class L5xReading {
 public:
  explicit L5xReading(const Reading& reading)
      : builder_(reading, address::Notation::rockwell),
        lines_(builder_.text()),
        tags_(builder_, RockwellTags::Texts::plain) {}

  std::optional<SymbolTable> read(const xml::Document& document) {
    const xml::Element controller = document.root().child("Controller");
    for (xml::Element part = controller.first_child(); part; part = part.next_sibling()) {
      if (part.name() == "Tags") take_tags(part, {});
      if (part.name() == "Modules") take_modules(part);
      if (part.name() == "Programs") take_programs(part);
    }
    builder_.decide("programs: " + std::to_string(programs_) + ", modules: " + std::to_string(modules_));
    tags_.make_rows();
    return builder_.finish();
  }

 private:
  std::string_view text_cell(const xml::Element& description) {
    return xml::content_cell(builder_, text_element(description));
  }

  void take_programs(const xml::Element& programs) {
    for (xml::Element program = programs.first_child(); program; program = program.next_sibling()) {
      ++programs_;
      const std::string_view scope = xml::attribute_cell(builder_, program, "Name");
      take_tags(program.child("Tags"), scope);
    }
  }

  void take_tags(const xml::Element& tags, std::string_view scope) {
    for (xml::Element tag = tags.first_child(); tag; tag = tag.next_sibling()) {
      if (tag.name() != "Tag") continue;
      const text::Span whole = tag.tag();
      const auto cell = [&](const char* name) { return xml::attribute_cell(builder_, tag, name); };
      RockwellTag made{scope,
                       cell("Name"),
                       type_of(tag),
                       cell("AliasFor"),
                       text_cell(tag.child("Description")),
                       lines_.line_at(whole.begin),
                       whole};
      if (made.name.empty()) {
        builder_.report(kRowWithoutIdentifier, "this tag has no name and is left out; give it one", whole);
        continue;
      }
      tags_.add(made);
      take_comments(tag.child("Comments"), scope, made.name);
    }
  }

  std::string_view type_of(const xml::Element& tag) {
    const std::string_view type = xml::attribute_cell(builder_, tag, "DataType");
    std::string dimensions(tag.attribute("Dimensions").text);
    if (dimensions.empty()) return type;
    std::replace(dimensions.begin(), dimensions.end(), ' ', ',');
    return builder_.keep(std::string(type).append("[").append(dimensions).append("]"));
  }

  /// The comments on parts of a tag.
  void take_comments(const xml::Element& comments, std::string_view scope, std::string_view tag) {
    for (xml::Element comment = comments.first_child(); comment; comment = comment.next_sibling()) {
      add_comment(scope, tag, comment.attribute("Operand").text, comment);
    }
  }

  void add_comment(std::string_view scope, std::string_view tag, std::string_view part, const xml::Element& text) {
    if (tag.size() + part.size() > kLongestOperand) return;
    const std::string_view comment = text_cell(text);
    if (comment.empty()) return;
    const text::Span whole = text.tag();
    const std::string operand = std::string(tag).append(part);
    tags_.add(RockwellComment{scope, one_line(builder_, std::string_view::npos, operand), comment,
                              lines_.line_at(whole.begin), whole});
  }

  void take_modules(const xml::Element& modules) {
    for (xml::Element module = modules.first_child(); module; module = module.next_sibling()) {
      ++modules_;
      const std::string path = module_path(module);
      if (path.size() > kLongestOperand) continue;
      const xml::Element connections = module.child("Communications").child("Connections");
      for (xml::Element connection = connections.first_child(); connection; connection = connection.next_sibling()) {
        for (const ModuleTag& tag : kModuleTags) take_module_tag(module, connection, path, tag);
      }
    }
  }

  void take_module_tag(const xml::Element& module, const xml::Element& connection, const std::string& path,
                       const ModuleTag& kind) {
    const xml::Element tag = connection.child(kind.element);
    if (!tag) return;
    const std::string_view given = connection.attribute(kind.suffix_attribute).text;
    if (given.size() > kLongestOperand) return;
    const std::string name = path + ":" + std::string(given.empty() ? kind.suffix : given);
    add_comment({}, name, {}, tag.child("Description"));
    add_comment({}, name, {}, module.child("Description"));
    take_comments(tag.child("Comments"), {}, name);
  }

  TableBuilder builder_;
  LineCounter lines_;
  RockwellTags tags_;
  std::size_t programs_ = 0;
  std::size_t modules_ = 0;
};

int rockwell_l5x_likelihood(std::string_view text) {
  return xml::read_prolog(text).root == "RSLogix5000Content" ? 95 : 0;
}

std::optional<SymbolTable> read_rockwell_l5x(const Reading& reading) {
  const auto document = xml::Document::parse(reading);
  if (!document) return std::nullopt;
  return L5xReading(reading).read(*document);
}

}  // namespace

const ReaderInfo kRockwellL5x{"rockwell-l5x", "Logix Designer project (L5X)", rockwell_l5x_likelihood,
                              read_rockwell_l5x};

}  // namespace symplant::read
