// The file of `convert --renames`.
#include "app/renames_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "read/cells/csv.hpp"
#include "text/ascii.hpp"

namespace symplant::app {
namespace {

struct NewName {
  std::string_view name;
  std::uint32_t line = 0;
  bool used = false;
};

/// A cell without the quote that keeps a spreadsheet from reading a formula.
std::string_view unprotected(std::string_view cell) {
  constexpr std::string_view kProtected = "=+-@";
  const bool is_protected = cell.size() > 1 && cell.front() == '\'' && kProtected.find(cell[1]) != cell.npos;
  return is_protected ? cell.substr(1) : cell;
}

class Renaming {
 public:
  Renaming(const std::string& file, std::string_view text) : file_(file) { read(text); }

  std::shared_ptr<const convert::Symbols> apply(const convert::Symbols& symbols) {
    auto renamed = std::make_shared<convert::Symbols>(symbols);
    for (convert::Symbol& symbol : renamed->all) {
      const auto found = names_.find(symbol.row->name);
      if (found == names_.end()) {
        kept_.insert({symbol.row->name, true});
        continue;
      }
      found->second.used = true;
      read::ListRow row = *symbol.row;
      row.name = renamed->texts.emplace_back(found->second.name);
      symbol.row = &renamed->rows.emplace_back(row);
    }
    check_names();
    return renamed;
  }

  std::vector<std::string> take_faults() { return std::move(faults_); }

 private:
  void fault(std::uint32_t line, const std::string& message) {
    faults_.push_back(fmt::format("{}:{}: error: {}", file_, line, message));
  }

  void read(std::string_view text) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    read::CsvReader csv(text, read::sniff_delimiter(text), arena_);
    read::CsvRow row;
    if (!csv.next(row)) return fault(1, "the file is empty; its first row is `old,new`");
    const auto column = [&](std::string_view name) {
      const auto found = std::find_if(row.cells.begin(), row.cells.end(),
                                      [&](std::string_view cell) { return text::equal_ignoring_case(cell, name); });
      return static_cast<std::size_t>(found - row.cells.begin());
    };
    const std::size_t from = column("old");
    const std::size_t to = column("new");
    if (from == row.cells.size() || to == row.cells.size()) {
      return fault(row.line, "the first row must name the columns `old` and `new`");
    }
    while (csv.next(row)) {
      if (!row.blank()) add(unprotected(row.cell(from)), unprotected(row.cell(to)), row.line);
    }
    if (csv.unclosed_quote()) fault(row.line, "a quote is never closed; close it");
  }

  void add(std::string_view from, std::string_view to, std::uint32_t line) {
    if (from.empty() || to.empty()) return fault(line, "a name is empty; write both, or delete the row");
    const auto [found, added] = names_.try_emplace(from, NewName{to, line});
    if (!added)
      fault(line, fmt::format("`{}` is renamed in line {} already; delete one row", from, found->second.line));
  }

  void check_names() {
    std::vector<std::pair<std::string_view, NewName>> in_order(names_.begin(), names_.end());
    std::sort(in_order.begin(), in_order.end(),
              [](const auto& a, const auto& b) { return a.second.line < b.second.line; });
    text::ByName<std::uint32_t> taken;
    for (const auto& [old, renamed] : in_order) {
      if (!renamed.used) fault(renamed.line, fmt::format("no symbol is called `{}`; correct or delete the row", old));
      if (kept_.count(renamed.name) != 0) {
        fault(renamed.line, fmt::format("another symbol is called `{}`; choose another name", renamed.name));
      }
      const auto [first, added] = taken.try_emplace(renamed.name, renamed.line);
      if (!added) fault(renamed.line, fmt::format("`{}` is the new name in line {}, too", renamed.name, first->second));
    }
  }

  const std::string& file_;
  std::deque<std::string> arena_;
  text::ByName<NewName> names_;  ///< by old name
  text::ByName<bool> kept_;      ///< names that do not change
  std::vector<std::string> faults_;
};

}  // namespace

base::Result<std::shared_ptr<const convert::Symbols>, std::vector<std::string>> rename_symbols(
    const convert::Symbols& symbols, const std::string& file, const base::FileSystem& files) {
  const auto bytes = files.read(file);
  if (!bytes) return std::vector<std::string>{"error: " + bytes.error().message};
  Renaming renaming(file, *bytes);
  auto renamed = renaming.apply(symbols);
  if (std::vector<std::string> faults = renaming.take_faults(); !faults.empty()) return faults;
  return renamed;
}

}  // namespace symplant::app
