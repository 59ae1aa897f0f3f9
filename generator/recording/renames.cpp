// Reads the file of `--rename`: which symbol a name of a recording is.
#include "recording/renames.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>
#include <utility>

#include "read/cells/csv.hpp"
#include "recording/decoding.hpp"
#include "recording/table_rows.hpp"
#include "text/ascii.hpp"

namespace symplant::recording {
namespace {

class RenamesReader {
 public:
  RenamesReader(const std::string& name, std::string_view text)
      : name_(name), rows_(text, read::sniff_delimiter(text)) {}

  ReadRenames run() {
    for (bool first = true; read_.error.empty() && rows_.next();) {
      if (rows_.blank() || rows_.cell(0).starts_with('#')) continue;
      if (first && text::equal_ignoring_case(rows_.cell(0), "symbol")) {
        fail(0, "the columns are swapped; write the name in the recording first, then the symbol");
      } else if (!first || !is_header()) {
        take();
      }
      first = false;
    }
    if (read_.error.empty() && rows_.has_unclosed_quote()) {
      read_.error = fmt::format("{}:{}: a quote is never closed; close it", name_, rows_.line());
    }
    return std::move(read_);
  }

 private:
  void fail(std::size_t column, std::string_view what) {
    read_.error = fmt::format("{}:{}:{}: {}", name_, rows_.line(), column + 1, what);
  }

  bool is_header() const {
    return text::equal_ignoring_case(rows_.cell(1), "symbol") || text::equal_ignoring_case(rows_.cell(1), "new");
  }

  void take() {
    const auto& cells = rows_.cells();
    if (cells.size() < 2) return fail(1, "there is one cell; write two: the name in the recording, and the symbol");
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (c < 2 && cells[c].empty()) return fail(c, "the name is empty; write it, or delete the row");
      if (c >= 2 && !cells[c].empty()) {
        return fail(
            c, fmt::format("there is `{}`; a row has two cells: the name in the recording, and the symbol", cells[c]));
      }
    }
    const auto [from, is_new] = from_.emplace(std::string(cells[0]), rows_.line());
    if (!is_new) {
      return fail(0, fmt::format("`{}` is in line {}, too; delete one row", cells[0], from->second));
    }
    read_.renames.emplace_back(cells[0], cells[1]);
  }

  const std::string& name_;
  TableRows rows_;
  std::unordered_map<std::string, std::uint32_t> from_;
  ReadRenames read_;
};

}  // namespace

ReadRenames read_renames(std::string bytes, const std::string& name) {
  std::vector<std::string> warnings;
  const auto text = decoded(std::move(bytes), name, warnings);
  if (!text) return {{}, text.error().message, {}};
  ReadRenames read = RenamesReader(name, *text).run();
  read.warnings = std::move(warnings);
  return read;
}

}  // namespace symplant::recording
