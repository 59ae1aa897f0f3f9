// Reads the links of a naming rule from a CSV file.
#include "naming/links_file.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <string_view>
#include <utility>

#include "description/faults.hpp"
#include "naming/rules/naming_contradiction.hpp"
#include "naming/rules/naming_schema.hpp"
#include "read/cells/csv.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"

namespace symplant::naming {
namespace {

using description::ticked;

constexpr std::array<std::string_view, 3> kColumns{"operation", "event", "state"};

class LinksReader {
 public:
  LinksReader(const std::shared_ptr<const text::SourceFile>& source, diag::Diagnostics& diagnostics)
      : source_(source),
        diagnostics_(diagnostics),
        csv_(source->text(), read::sniff_delimiter(first_line(source->text())), arena_) {}

  LinksFile read() {
    read::CsvRow row;
    const bool more = next(row);
    if (!more && !csv_.unclosed_quote()) {
      add(kNamingSchema, "the file of links is empty; its first row is `operation,event,state`", {});
    } else if (more && read_header(row)) {
      while (next(row)) read_row(row);
    }
    if (csv_.unclosed_quote()) {
      const std::size_t quote = *csv_.unclosed_quote();
      add(kNamingSchema, "this quote is never closed; write `\"` at the end of the cell", {quote, quote + 1});
    }
    return std::move(file_);
  }

 private:
  /// The first line that is neither blank nor a comment.
  static std::string_view first_line(std::string_view text) {
    while (!text.empty()) {
      const std::string_view line = text.substr(0, text.find('\n'));
      if (!line.starts_with('#') && line.find_first_not_of(" \t\r,;") != std::string_view::npos) return line;
      text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return text;
  }

  /// The next row that is neither blank nor a comment.
  bool next(read::CsvRow& row) {
    while (csv_.next(row)) {
      if (!row.blank() && source_->text()[row.whole.begin] != '#') return true;
    }
    return false;
  }

  void add(const diag::RuleInfo& rule, std::string message, text::Span span) {
    diagnostics_.add(rule, std::move(message), {source_, span});
  }

  /// Whether the row has all columns.
  bool read_header(const read::CsvRow& row) {
    bool known = true;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const auto* column = std::find_if(kColumns.begin(), kColumns.end(), [&](std::string_view name) {
        return text::equal_ignoring_case(name, row.cells[i]);
      });
      if (column != kColumns.end()) {
        columns_[static_cast<std::size_t>(column - kColumns.begin())] = i;
      } else if (!row.cells[i].empty()) {
        known = false;
        unknown_column(row.cells[i], row.whole);
      }
    }
    std::string missing;
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      if (!columns_[i]) missing += (missing.empty() ? "" : ", ") + ticked(kColumns[i]);
    }
    if (known && !missing.empty()) {
      add(kNamingSchema, "the first row lacks " + missing + "; write `operation,event,state`", row.whole);
    }
    return missing.empty();
  }

  void unknown_column(std::string_view cell, const text::Span& row) {
    tables::NearestName nearest(cell);
    for (const std::string_view name : kColumns) nearest.offer(name);
    add(kNamingSchema,
        "unknown column " + ticked(cell) + "; " +
            (nearest.name().empty() ? "the columns are `operation`, `event` and `state`"
                                    : "did you mean " + ticked(nearest.name()) + "?"),
        source_->span_of(cell, row));
  }

  void read_row(const read::CsvRow& row) {
    const auto cell = [&](std::size_t column) { return std::string(row.cell(*columns_[column])); };
    name::NamedLink link{cell(0), cell(1), cell(2)};
    if (const std::string fault = link_fault(link, file_.links.empty()); !fault.empty()) {
      add(kNamingContradiction, fault, row.whole);
    } else {
      file_.links.push_back(std::move(link));
      file_.rows.push_back(row.whole);
    }
  }

  const std::shared_ptr<const text::SourceFile>& source_;
  diag::Diagnostics& diagnostics_;
  std::deque<std::string> arena_;
  read::CsvReader csv_;
  std::array<std::optional<std::size_t>, 3> columns_;
  LinksFile file_;
};

}  // namespace

std::string link_fault(const name::NamedLink& link, bool first) {
  if (link.event.empty()) return "the row has no event; write the symbol that reports the state, or remove the row";
  if (link.state.empty()) return "the row has no state; write the state that the operation leads to";
  if (first && link.operation.empty()) {
    return "the first row has no operation; an empty operation continues the row above";
  }
  return {};
}

LinksFile read_links_file(const std::shared_ptr<const text::SourceFile>& source, diag::Diagnostics& diagnostics) {
  return LinksReader(source, diagnostics).read();
}

}  // namespace symplant::naming
