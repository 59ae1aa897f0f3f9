// Writes PLCopen XML (TC6): for CODESYS, TwinCAT and the editor of OpenPLC.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "convert/declarations.hpp"
#include "convert/formats.hpp"
#include "convert/losses.hpp"
#include "convert/types.hpp"
#include "convert/xml_text.hpp"

namespace symplant::convert {
namespace {

/// The element of a type that is not an array.
std::string simple_type_element(std::string_view type) {
  if (const std::string_view length = string_length(type); !length.empty()) {
    return fmt::format("<{} length=\"{}\"/>", type.starts_with('W') ? "wstring" : "string", length);
  }
  if (type == "STRING") return "<string/>";
  if (type == "WSTRING") return "<wstring/>";
  const bool is_later = type == "CHAR" || type == "WCHAR" || type == "LTIME" || type == "LTOD";  // than the schema
  return is_later ? fmt::format("<derived name=\"{}\"/>", type) : fmt::format("<{}/>", type);
}

/// The bounds of one dimension: 0..7
std::string dimension_element(std::string_view bounds) {
  const std::size_t dots = std::min(bounds.find(".."), bounds.size());
  const auto trimmed = [](std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" ."), text.size());
    text.remove_prefix(begin);
    return text.substr(0, text.find_last_not_of(' ') + 1);
  };
  return fmt::format("<dimension lower=\"{}\" upper=\"{}\"/>", trimmed(bounds.substr(0, dots)),
                     trimmed(bounds.substr(dots)));
}

std::string type_element(std::string_view type) {
  const auto array = array_type(type);
  if (!array) return simple_type_element(type);
  std::string text = "<array>";
  for (std::string_view rest = array->bounds; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    text += dimension_element(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return text + "<baseType>" + simple_type_element(array->element) + "</baseType></array>";
}

/// `element` holds the comment: CODESYS writes `xhtml`, OpenPLC `p`.
void append_variable(std::string& text, const Declaration& declaration, std::string_view element) {
  text.append("        <variable name=\"").append(declaration.name).append("\"");
  if (!declaration.address.empty()) text.append(" address=\"").append(declaration.address).append("\"");
  text.append(">\n          <type>").append(type_element(declaration.type)).append("</type>\n");
  if (!declaration.initial.empty()) {
    text += "          <initialValue><simpleValue value=\"";
    append_xml(text, declaration.initial);
    text += "\"/></initialValue>\n";
  }
  if (!declaration.comment.empty()) {
    text.append("          <documentation><").append(element).append(" xmlns=\"http://www.w3.org/1999/xhtml\">");
    append_xml(text, declaration.comment);
    text.append("</").append(element).append("></documentation>\n");
  }
  text += "        </variable>\n";
}

constexpr std::string_view kHead =
    R"(  <fileHeader companyName="" productName="symplant" productVersion="1" creationDateTime="2000-01-01T00:00:00"/>
  <contentHeader name="plant">
    <coordinateInfo>
      <fbd><scaling x="1" y="1"/></fbd>
      <ld><scaling x="1" y="1"/></ld>
      <sfc><scaling x="1" y="1"/></sfc>
    </coordinateInfo>
  </contentHeader>
  <types>
    <dataTypes/>
)";

constexpr std::string_view kProgramHead = R"(    <pous>
      <pou name="symplant_io" pouType="program">
      <interface>
)";

constexpr std::string_view kProgramFoot = R"(      </interface>
      <body>
        <ST><p xmlns="http://www.w3.org/1999/xhtml">RETURN;</p></ST>
      </body>
      </pou>
    </pous>
  </types>
  <instances>
    <configurations>
      <configuration name="Config0">
        <resource name="Res0">
          <task name="task0" priority="0" interval="T#20ms">
            <pouInstance name="instance0" typeName="symplant_io"/>
          </task>
        </resource>
      </configuration>
    </configurations>
  </instances>
)";

constexpr std::string_view kListsHead = R"(    <pous/>
  </types>
  <instances>
    <configurations/>
  </instances>
  <addData>
)";

void put_variables(base::PartCollector& parts, const Declarations& declarations, const DeclarationGroup& group) {
  std::string text;
  for (const std::uint32_t symbol : group.symbols) {
    text.clear();
    append_variable(text, declarations[symbol], declarations.dialect().program ? "p" : "xhtml");
    parts.add(text);
  }
}

std::string_view constant_attribute(const DeclarationGroup& group) {
  return group.kind == Kind::constant ? " constant=\"true\"" : "";
}

/// Variables of one program: OpenPLC locates no others.
void put_program(base::PartCollector& parts, const Declarations& declarations) {
  parts.add(kProgramHead);
  for (const DeclarationGroup& group : declarations.groups()) {
    parts.add(fmt::format("      <localVars{}>\n", constant_attribute(group)));
    put_variables(parts, declarations, group);
    parts.add("      </localVars>\n");
  }
  parts.add(kProgramFoot);
}

std::string_view list_name(Kind kind) {
  switch (kind) {
    case Kind::input:
      return "IO_Inputs";
    case Kind::output:
      return "IO_Outputs";
    case Kind::internal:
      return "IO_Variables";
    case Kind::constant:
      break;
  }
  return "IO_Constants";
}

/// Global variable lists, as CODESYS and TwinCAT export them: each in its data element.
void put_lists(base::PartCollector& parts, const Declarations& declarations) {
  parts.add(kListsHead);
  for (const DeclarationGroup& group : declarations.groups()) {
    parts.add(
        "    <data name=\"http://www.3s-software.com/plcopenxml/globalvars\" handleUnknown=\"implementation\">\n");
    parts.add(fmt::format("      <globalVars name=\"{}\"{}>\n", list_name(group.kind), constant_attribute(group)));
    put_variables(parts, declarations, group);
    parts.add("      </globalVars>\n    </data>\n");
  }
  parts.add("  </addData>\n");
}

base::Result<Output, WriteError> write_plcopen(const Writing& writing) {
  const auto declarations = std::make_shared<const Declarations>(writing);
  for (const DeclarationGroup& group : declarations->groups()) {
    for (const std::uint32_t i : group.symbols) {
      const read::ListRow& row = *declarations->symbols().all[i].row;
      if (!is_xml_text(row.comment)) writing.report.add(kCommentChanged, row.name);
    }
  }
  const base::TextSource text = [declarations](base::TextSink& sink) {
    base::PartCollector parts(sink);
    const bool program = declarations->dialect().program;
    parts.add(
        fmt::format("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<project xmlns=\"http://www.plcopen.org/xml/{}\">\n",
                    program ? "tc6_0201" : "tc6_0200"));
    parts.add(kHead);
    program ? put_program(parts, *declarations) : put_lists(parts, *declarations);
    parts.add("</project>\n");
    parts.finish();
  };
  return Output{text, declarations->written()};
}

}  // namespace

const WriterInfo kPlcopenWriter{"plcopen", "PLCopen XML (TC6)", ".xml", true, true, write_plcopen};

}  // namespace symplant::convert
