// Writes declarations in structured text: for CODESYS, TwinCAT and OpenPLC.
#include <algorithm>
#include <memory>
#include <string>

#include "convert/declarations.hpp"
#include "convert/formats.hpp"
#include "convert/losses.hpp"

namespace symplant::convert {
namespace {

/// A comment on one line ends with it. OpenPLC's compiler has only comments in brackets.
bool fits_on_a_line(std::string_view comment, const Dialect& dialect) {
  return !dialect.program && comment.find_first_of("\r\n") == comment.npos;
}

/// A comment in brackets: nothing in the text may end it, or begin another.
std::string bracketed(std::string_view comment) {
  std::string text;
  for (std::size_t i = 0; i < comment.size(); ++i) {
    text += comment[i];
    const std::string_view pair = comment.substr(i, 2);
    if (pair == "(*" || pair == "*)") text += ' ';
  }
  return text;
}

std::string without_controls(std::string_view comment) {
  std::string text(comment);
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r'; }, ' ');
  return text;
}

/// The comment's text between its marks.
std::string st_comment(std::string_view comment, const Dialect& dialect) {
  const std::string text = without_controls(comment);
  return fits_on_a_line(comment, dialect) ? text : bracketed(text);
}

void append_declaration(std::string& text, const Declaration& declaration, const Dialect& dialect) {
  text.append("  ").append(declaration.name);
  if (!declaration.address.empty()) text.append(" AT ").append(declaration.address);
  text.append(" : ").append(declaration.type);
  if (!declaration.initial.empty()) text.append(" := ").append(declaration.initial);
  text += ';';
  if (!declaration.comment.empty()) {
    const bool is_line = fits_on_a_line(declaration.comment, dialect);
    text.append(is_line ? " // " : " (* ").append(st_comment(declaration.comment, dialect));
    if (!is_line) text += " *)";
  }
  text += '\n';
}

void put_group(base::PartCollector& parts, const Declarations& declarations, const DeclarationGroup& group) {
  const Dialect& dialect = declarations.dialect();
  std::string text = "\n(* " + std::string(group.title) + " *)\n";
  text.append(dialect.program ? "VAR" : "VAR_GLOBAL").append(group.kind == Kind::constant ? " CONSTANT\n" : "\n");
  parts.add(text);
  for (const std::uint32_t symbol : group.symbols) {
    text.clear();
    append_declaration(text, declarations[symbol], dialect);
    parts.add(text);
  }
  parts.add("END_VAR\n");
}

constexpr std::string_view kProgramBegin = "\nPROGRAM symplant_io\n";
constexpr std::string_view kProgramEnd =
    "\nRETURN;  (* the program; the compiler wants one statement *)\n"
    "END_PROGRAM\n\n"
    "CONFIGURATION Config0\n"
    "  RESOURCE Res0 ON PLC\n"
    "    TASK task0(INTERVAL := T#20ms, PRIORITY := 0);\n"
    "    PROGRAM instance0 WITH task0 : symplant_io;\n"
    "  END_RESOURCE\n"
    "END_CONFIGURATION\n";

base::Result<Output, WriteError> write_st(const Writing& writing) {
  const auto declarations = std::make_shared<const Declarations>(writing);
  for (const DeclarationGroup& group : declarations->groups()) {
    for (const std::uint32_t i : group.symbols) {
      const read::ListRow& row = *declarations->symbols().all[i].row;
      if (st_comment(row.comment, writing.dialect) != row.comment) writing.report.add(kCommentChanged, row.name);
    }
  }
  const base::TextSource text = [declarations](base::TextSink& sink) {
    base::PartCollector parts(sink);
    const Dialect& dialect = declarations->dialect();
    parts.add("(* Variables for " + std::string(dialect.title) + ", written by symplant. *)\n");
    if (dialect.program) parts.add(kProgramBegin);
    for (const DeclarationGroup& group : declarations->groups()) put_group(parts, *declarations, group);
    if (dialect.program) parts.add(kProgramEnd);
    parts.finish();
  };
  return Output{text, declarations->written()};
}

}  // namespace

const WriterInfo kStWriter{"st", "declarations in structured text", ".st", true, true, write_st};

}  // namespace symplant::convert
