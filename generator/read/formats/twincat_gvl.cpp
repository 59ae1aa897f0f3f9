// Reads global variable lists and programs of TwinCAT 3 (.TcGVL, .TcPOU).
#include <string>

#include "read/formats.hpp"
#include "read/st/declared_rows.hpp"
#include "read/xml/cells.hpp"
#include "read/xml/prolog.hpp"

namespace symplant::read {

namespace {

/// Reads the declaration of a list or a program: in the file itself if it is there as such, so that findings point to
/// its lines.
void read_declaration(TableBuilder& builder, DeclaredRows& rows, const xml::Element& declaration,
                      std::string_view scope) {
  std::string joined;
  const xml::Text text = declaration.content(joined);
  if (text.offset < builder.text().size() && builder.text().substr(text.offset, text.text.size()) == text.text) {
    rows.read({text.offset, text.offset + text.text.size()}, scope);
  } else if (!text.text.empty()) {
    rows.read_copy(builder.keep(std::string(text.text)), declaration.tag(), scope);
  }
}

int twincat_gvl_likelihood(std::string_view text) { return xml::read_prolog(text).root == "TcPlcObject" ? 95 : 0; }

std::optional<SymbolTable> read_twincat_gvl(const Reading& reading) {
  const auto document = xml::Document::parse(reading);
  if (!document) return std::nullopt;
  TableBuilder builder(reading, address::Notation::iec);
  DeclaredRows rows(builder);
  for (xml::Element object = document->root().first_child(); object; object = object.next_sibling()) {
    const std::string_view name = xml::attribute_cell(builder, object, "Name");
    const xml::Element declaration = object.child("Declaration");
    if (declaration) read_declaration(builder, rows, declaration, name);
  }
  return rows.finish();
}

}  // namespace

const ReaderInfo kTwincatGvl{"twincat-gvl", "TwinCAT 3 global variable list", twincat_gvl_likelihood, read_twincat_gvl};

}  // namespace symplant::read
