// Where a table of another tool has its times, names and values.
#include "recording/table_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "recording/column_names.hpp"
#include "recording/table_rows.hpp"
#include "recording/table_values.hpp"
#include "text/ascii.hpp"

namespace symplant::recording {
namespace {

/// A header lies within the first rows.
constexpr std::size_t kHeaderRows = 1000;
constexpr std::array kDelimiters{'\t', ';', ','};  // a comma may also be that of decimals

using Cells = std::vector<std::string_view>;

std::size_t filled(const Cells& cells) {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); }));
}

/// Whether a cell is a time of day without a date.
bool is_time_of_day(std::string_view cell) {
  const std::size_t colon = cell.find(':');
  return colon != cell.npos && colon <= 2 && is_time(cell);
}

/// Reads the table as if it had a certain delimiter.
class LayoutFinder {
 public:
  LayoutFinder(std::string_view text, char delimiter, const std::string& name, const ReadOptions& options)
      : name_(name), options_(options), rows_(text, delimiter) {
    layout_.delimiter = delimiter;
  }

  /// False if no row is a header, or no row of values follows; then the layout has the error, if a header was found.
  bool run() {
    for (std::size_t row = 0; row < kHeaderRows && rows_.next(); ++row) {
      if (rows_.blank()) continue;
      if (row == 0 && rows_.cell(0) == "[LOGGING]") is_logging_ = true;
      if (has_header_ && is_data()) {
        layout_.data_line = rows_.line();
        settle();
        return true;
      }
      if (!take_header() && has_header_) take_below_header();
    }
    if (has_header_ && layout_.error.empty() && rows_.has_unclosed_quote() && !rows_.is_cut_in_quote()) {
      layout_.error = fmt::format("{}:{}: a quote is never closed; close it", name_, rows_.line());
    }
    if (has_header_ && layout_.error.empty()) {
      layout_.error =
          fmt::format("{}:{}: no row with a time and values follows this header", name_, layout_.header_line);
    }
    return false;
  }

  TableLayout& layout() { return layout_; }

 private:
  bool take_header() {
    const Cells& cells = rows_.cells();
    if (filled(cells) < 2) return false;
    TableLayout found;
    row_is_scope_ = false;
    if (!options_.time_column.empty()) {
      if (!take_named(cells, found)) return false;
    } else if (!take_times(cells, found)) {
      return false;
    }
    found.delimiter = layout_.delimiter;
    found.header_line = rows_.line();
    found.names.assign(cells.begin(), cells.end());
    layout_ = std::move(found);
    is_scope_ = row_is_scope_;
    has_header_ = true;
    return true;
  }

  /// The column that --time-column names, by its header or number.
  bool take_named(const Cells& cells, TableLayout& found) {
    const std::string& wanted = options_.time_column;
    const auto same = std::find_if(cells.begin(), cells.end(),
                                   [&](std::string_view cell) { return text::equal_ignoring_case(cell, wanted); });
    auto column = static_cast<std::size_t>(same - cells.begin());
    if (same == cells.end()) {
      const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), column);
      if (error != std::errc() || end != wanted.data() + wanted.size() || column == 0 || column > cells.size()) {
        return false;
      }
      --column;
      if (is_time(cells[column])) return false;
    }
    found.times.push_back({column, {}, column_header(cells[column]).form, {}});
    return take_columns(cells, found);
  }

  bool take_times(const Cells& cells, TableLayout& found) {
    std::vector<std::size_t> dates;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const ColumnHeader header = column_header(cells[c]);
      if (header.role == ColumnRole::date) dates.push_back(c);
      if (header.role == ColumnRole::date || header.role == ColumnRole::time) {
        found.times.push_back({c, {}, header.form, {}});
      }
    }
    if (found.times.size() == 2 && dates.size() == 1) join_date(dates[0], found.times);
    if (found.times.empty() && cells[0] == "Name") {
      row_is_scope_ = true;
      for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c] == "Name") found.times.push_back({c, {}, TimeForm::unknown, {}});
      }
    }
    return !found.times.empty() && take_columns(cells, found);
  }

  /// `Date;Time` next to each other are one time.
  static void join_date(std::size_t date, std::vector<TimeColumn>& times) {
    const std::size_t other = times[0].column == date ? 1 : 0;
    const std::size_t column = times[other].column;
    if (column + 1 != date && date + 1 != column) return;
    if (times[other].form != TimeForm::unknown) return;
    times = {{column, date, TimeForm::unknown, {}}};
  }

  bool take_columns(const Cells& cells, TableLayout& found) const {
    if (take_long(cells, found)) return true;
    const auto is_time_column = [&](std::size_t column) {
      return std::any_of(found.times.begin(), found.times.end(),
                         [&](const TimeColumn& time) { return time.column == column || time.date == column; });
    };
    for (std::size_t c = 0, of = 0; c < cells.size(); ++c) {
      while (of + 1 < found.times.size() && found.times[of + 1].column <= c) ++of;
      if (is_time_column(c) || (is_logging_ && is_logging_column(cells[c]))) continue;
      found.times[of].values.push_back(c);
    }
    std::erase_if(found.times, [](const TimeColumn& time) { return time.values.empty(); });
    return !found.times.empty();
  }

  bool take_long(const Cells& cells, TableLayout& found) const {
    std::vector<std::size_t> of_role[3];
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const ColumnRole role = column_header(cells[c]).role;
      if (role == ColumnRole::symbol) of_role[0].push_back(c);
      if (role == ColumnRole::value) of_role[1].push_back(c);
      if (role == ColumnRole::validity) of_role[2].push_back(c);
    }
    if (row_is_scope_ || of_role[0].size() != 1 || of_role[1].size() != 1) return false;
    found.by_row = LongColumns{of_role[0][0], of_role[1][0], {}};
    if (!of_role[2].empty()) found.by_row->validity = of_role[2][0];
    // Panels of Siemens have a text of seconds, and millionths of a day.
    const auto exact = std::find_if(found.times.begin(), found.times.end(), [&](const TimeColumn& time) {
      return text::equal_ignoring_case(cells[time.column], "Time_ms") &&
             text::equal_ignoring_case(cells[of_role[0][0]], "VarName");
    });
    if (exact != found.times.end()) {
      exact->form = TimeForm::day_million;
      found.times = {*exact};
    }
    found.times.resize(1);
    return true;
  }

  bool is_data() const {
    bool any = false;
    for (const TimeColumn& time : layout_.times) {
      const std::string_view cell = rows_.cell(time.column);
      if (cell.empty()) continue;
      if (!is_time(cell)) return false;
      any = true;
    }
    return any;
  }

  /// Rows of units, types and comments lie between a header and the values.
  void take_below_header() {
    const Cells& cells = rows_.cells();
    if (is_scope_) {
      if (cells[0] == "SymbolName" && cells.size() >= layout_.names.size()) take_symbol_names(cells);
      return;
    }
    for (TimeColumn& time : layout_.times) {
      std::string_view cell = rows_.cell(time.column);
      if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '(')) cell = cell.substr(1, cell.size() - 2);
      if (time.form == TimeForm::unknown) time.form = time_form_of(cell);
    }
    const TimeColumn& time = layout_.times.front();
    const std::string_view cell = rows_.cell(time.column);
    const bool has_values = std::any_of(time.values.begin(), time.values.end(),
                                        [&](std::size_t column) { return cell_value(rows_.cell(column)).has_value(); });
    if (!has_values || cell.empty() || cell.front() == '#' || !layout_.error.empty()) return;
    layout_.error = fmt::format(
        "{}:{}:{}: `{}` is not a time; write a number, or a time such as "
        "2024-12-31T23:59:59.5",
        name_, rows_.line(), time.column + 1, cell);
  }

  void take_symbol_names(const Cells& cells) {
    for (std::size_t c = 0; c < layout_.names.size(); ++c) {
      if (!cells[c].empty()) layout_.names[c] = cells[c];
    }
  }

  /// What only the first row of values shows.
  void settle() {
    layout_.error.clear();
    for (TimeColumn& time : layout_.times) {
      const std::string_view cell = rows_.cell(time.column);
      if (time.date && !is_time_of_day(cell)) time.date.reset();
      if (is_scope_ && time_form_in(cell) != TimeForm::filetime) time.form = TimeForm::ms;
    }
  }

  const std::string& name_;
  const ReadOptions& options_;
  TableRows rows_;
  TableLayout layout_;
  bool has_header_ = false;
  bool row_is_scope_ = false;
  bool is_scope_ = false;    ///< TwinCAT Scope: a block of keys and values, with `Name` above each column of times
  bool is_logging_ = false;  ///< a logging file of a Mitsubishi PLC
};

}  // namespace

TableLayout find_layout(std::string_view text, const std::string& name, const ReadOptions& options) {
  TableLayout failed;
  for (const char delimiter : kDelimiters) {
    LayoutFinder finder(text, delimiter, name, options);
    if (finder.run()) return std::move(finder.layout());
    if (failed.error.empty()) failed.error = std::move(finder.layout().error);
  }
  if (!failed.error.empty()) return failed;
  if (!options.time_column.empty()) {
    failed.error = fmt::format(
        "{}:1: no header has the column `{}`; give --time-column as the header or the number of "
        "the column with times",
        name, options.time_column);
    return failed;
  }
  failed.error = fmt::format(
      "{}:1: this is no trace, no VCD file and no table with a column of times; name that column "
      "in a header, such as `Time [ms]`, or with --time-column",
      name);
  return failed;
}

}  // namespace symplant::recording
