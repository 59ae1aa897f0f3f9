// A difference as text for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "diag/visible_text.hpp"
#include "diff/words.hpp"

namespace symplant::diff {
namespace {

constexpr std::size_t kMostLines = 20;

/// `marked`: quoted pieces are in back-ticks.
std::string line_of(const Words& words, bool marked) {
  std::string line;
  for (const Piece& piece : words) {
    const std::string text = diag::visible(piece.text);
    line += marked && piece.quoted ? "`" + text + "`" : text;
  }
  return line;
}

/// The cells of a row; an empty one is `-`.
std::string row_text(const std::vector<Words>& cells) {
  std::string text;
  for (const Words& cell : cells) {
    const std::string shown = line_of(cell, cell.size() > 1);
    text.append("  ").append(shown.empty() ? "-" : shown);
  }
  return text;
}

}  // namespace

void write_text(const Comparison& comparison, bool all, base::TextSink& sink) {
  const Report report = report_of(comparison, all ? std::string::npos : kMostLines, all);
  base::PartCollector out(sink);
  out.add(line_of(report.head, false) + "\n");
  for (const Section& section : report.sections) {
    out.add(section.title + "\n");
    for (const Words& cause : section.causes) out.add("  " + line_of(cause, true) + "\n");
    for (const auto& row : section.rows) out.add(row_text(row) + "\n");
    if (section.more != 0) out.add(fmt::format("  {} more; --verbose shows them\n", section.more));
  }
  out.add(report.summary + "\n");
  out.finish();
}

}  // namespace symplant::diff
