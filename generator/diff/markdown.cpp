// A difference as Markdown, for a pull request on GitHub or GitLab.
#include <fmt/format.h>

#include "diag/encode.hpp"
#include "diff/words.hpp"

namespace symplant::diff {
namespace {

constexpr std::size_t kMostRows = 50;  ///< of a table
constexpr std::size_t kOpenRows = 10;  ///< a longer table is collapsed

std::string markdown_of(const Words& words) {
  std::string text;
  for (const Piece& piece : words) text += piece.quoted ? diag::markdown_code(piece.text) : piece.text;
  return text;
}

void append_table(const Section& section, std::string& text) {
  if (section.rows.empty()) return;
  std::string line = "|";
  std::string rule = "|";
  for (const std::string& column : section.columns) {
    line += " " + column + " |";
    rule += "---|";
  }
  text += line + "\n" + rule + "\n";
  for (const auto& row : section.rows) {
    line = "|";
    for (const Words& cell : row) line += " " + markdown_of(cell) + " |";
    text += line + "\n";
  }
  text += "\n";
  if (section.more != 0) text += fmt::format("{} more rows are not shown.\n\n", section.more);
}

std::string section_text(const Section& section) {
  const bool collapsed = section.rows.size() > kOpenRows;
  std::string text =
      collapsed ? "<details><summary>" + section.title + "</summary>\n\n" : "**" + section.title + "**\n\n";
  for (const Words& cause : section.causes) text += "- " + markdown_of(cause) + "\n";
  if (!section.causes.empty()) text += "\n";
  append_table(section, text);
  if (collapsed) text += "</details>\n\n";
  return text;
}

}  // namespace

void write_markdown(const Comparison& comparison, base::TextSink& sink) {
  const Report report = report_of(comparison, kMostRows, false);
  base::PartCollector out(sink);
  out.add("**symplant diff** " + markdown_of(report.head) + ": " + report.summary + "\n");
  for (const Section& section : report.sections) {
    out.add("\n");
    std::string text = section_text(section);
    text.pop_back();  // sections are separated by one empty line
    out.add(text);
  }
  out.finish();
}

}  // namespace symplant::diff
