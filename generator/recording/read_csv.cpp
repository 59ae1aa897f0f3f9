// Reads tables of other tools: a row a time, a row a change, or columns of times and values side by side.
#include "recording/read_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/decoding.hpp"
#include "recording/input.hpp"
#include "recording/resolution.hpp"
#include "recording/table_changes.hpp"
#include "recording/table_layout.hpp"
#include "recording/table_rows.hpp"
#include "text/ascii.hpp"

namespace symplant::recording {
namespace {

using tables::Time;

/// A column of times as far as it was read.
struct Clock {
  TimeReader reader;
  std::vector<Time> times;  ///< of all rows
};

class TableReader {
 public:
  TableReader(ReadRecording& read, std::string_view text, TableLayout layout, const ReadOptions& options)
      : read_(read),
        text_(text),
        layout_(std::move(layout)),
        options_(options),
        renamer_(options.renames),
        changes_(read, renamer_),
        rows_(text, layout_.delimiter) {
    if (!options.time_unit.empty()) unit_ = time_form_of(options.time_unit);
  }

  void run() {
    if (!settle_forms()) return;
    if (!layout_.by_row) add_columns();
    while (!ended_ && read_.error.empty() && rows_.next()) {
      if (rows_.line() >= layout_.data_line) take_row();
    }
    if (rows_.has_unclosed_quote()) {
      if (rows_.is_cut_in_quote()) {
        cut_off();
      } else {
        read_.error = fmt::format("{}:{}: a quote is never closed; close it", read_.recording.name, rows_.line());
      }
    }
    if (read_.error.empty()) finish();
  }

 private:
  void fail(std::size_t column, std::string_view text) { read_.error = changes_.at_cell({rows_.line(), column}, text); }

  void cut_off() {
    read_.warnings.push_back(
        fmt::format("{}:{}: the last line is cut off, and is left out", read_.recording.name, rows_.line()));
  }

  /// Finds the forms of times: by the option, the cells, the header, in this order. False with the error.
  bool settle_forms() {
    constexpr std::size_t kMostRows = 1000;
    std::vector<TimeForm> shown(layout_.times.size());
    TableRows rows(text_, layout_.delimiter);
    for (std::size_t count = 0; count < kMostRows && rows.next();) {
      if (rows.line() < layout_.data_line) continue;
      ++count;
      for (std::size_t i = 0; i < shown.size(); ++i) {
        if (shown[i] == TimeForm::unknown) shown[i] = time_form_in(rows.cell(layout_.times[i].column));
      }
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const TimeColumn& time = layout_.times[i];
      TimeForm form = shown[i] == TimeForm::calendar || time.form == TimeForm::unknown ? shown[i] : time.form;
      if (unit_ != TimeForm::unknown) form = given_unit(time, shown[i]);
      if (form == TimeForm::unknown) {
        read_.error = changes_.at_cell(
            {layout_.header_line, time.column},
            fmt::format("the unit of the times in column `{}` is not known; give it, such as --time-unit ms",
                        layout_.names[time.column]));
        return false;
      }
      clocks_.push_back({TimeReader(form), {}});
    }
    return true;
  }

  /// The unit of --time-unit, with a warning if the header has another one. Cells with dates are dates.
  TimeForm given_unit(const TimeColumn& time, TimeForm shown) {
    const bool are_dates = unit_ == TimeForm::calendar && shown == unit_;
    if (time.form != TimeForm::unknown && time.form != unit_ && !are_dates) {
      read_.warnings.push_back(changes_.at_cell(
          {layout_.header_line, time.column},
          fmt::format("the times in column `{}` are in {} by the header, and --time-unit is {}, which counts",
                      layout_.names[time.column], words_of(time.form), words_of(unit_))));
    }
    return unit_;
  }

  void add_columns() {
    for (const TimeColumn& time : layout_.times) {
      for (const std::size_t column : time.values) {
        const std::string& name = layout_.names[column];
        const CellAt at{layout_.header_line, column};
        columns_.push_back(name.empty() ? std::nullopt : std::optional(changes_.add(name, at)));
      }
    }
  }

  void take_row() {
    if (rows_.blank()) {
      after_blank_ = true;
      return;
    }
    if (is_end() || is_footer()) {
      ended_ = true;
      return;
    }
    if (rows_.cell(0).starts_with('#')) return;
    if (rows_.is_open()) {
      take_open_row();
    } else {
      take_cells();
    }
    cells_above_ = rows_.cells().size();
    after_blank_ = false;
  }

  void take_cells() {
    check_size();
    if (read_.error.empty()) layout_.by_row ? take_change() : take_times();
  }

  /// A last row without a line end: if it is not complete, it is left out as a whole.
  void take_open_row() {
    std::vector<std::size_t> counts;
    for (const Clock& clock : clocks_) counts.push_back(clock.times.size());
    changes_.begin_undo();
    const bool is_short = rows_.cells().size() < cells_above_;
    if (!is_short) take_cells();
    if (!is_short && read_.error.empty()) return;
    changes_.undo();
    for (std::size_t i = 0; i < counts.size(); ++i) clocks_[i].times.resize(counts[i]);
    read_.error.clear();
    cut_off();
  }

  bool is_end() const {
    const auto& cells = rows_.cells();
    return text::equal_ignoring_case(cells[0], "EOF") &&
           std::all_of(cells.begin() + 1, cells.end(), [](std::string_view cell) { return cell.empty(); });
  }

  /// After an empty line what is no row of the table does not belong to it.
  bool is_footer() {
    if (!after_blank_ || is_time(rows_.cell(layout_.times.front().column))) return false;
    read_.warnings.push_back(fmt::format("{}:{}: what follows the empty line is left out: it is no row with a time",
                                         read_.recording.name, rows_.line()));
    return true;
  }

  void check_size() {
    const auto& cells = rows_.cells();
    for (std::size_t c = layout_.names.size(); c < cells.size(); ++c) {
      if (cells[c].empty()) continue;
      return fail(c, fmt::format("there is `{}`, but the header has {} columns; if numbers have a decimal comma, "
                                 "separate cells by `;`",
                                 cells[c], layout_.names.size()));
    }
  }

  std::optional<Time> time_of(const TimeColumn& column, TimeReader& reader) {
    const std::string_view cell = rows_.cell(column.column);
    const auto time = column.date ? reader.read(rows_.cell(*column.date), cell) : reader.read(cell);
    if (!time) fail(column.column, fmt::format("`{}` is not a time; {}", cell, reader.error()));
    return time;
  }

  bool is_before(std::optional<Time> last, Time time, std::size_t column) {
    if (!last || time >= *last) return false;
    fail(column,
         fmt::format("the time `{}` is before that of the row above; sort the rows by time", rows_.cell(column)));
    return true;
  }

  /// A row with the values of all symbols, or of all symbols of each column of times.
  void take_times() {
    auto column = columns_.begin();
    for (std::size_t i = 0; i < layout_.times.size(); ++i) {
      const TimeColumn& time = layout_.times[i];
      const auto begin = std::exchange(column, column + static_cast<std::ptrdiff_t>(time.values.size()));
      if (rows_.cell(time.column).empty()) {
        if (!check_empty(time)) return;
        continue;
      }
      const auto at = time_of(time, clocks_[i].reader);
      std::vector<Time>& times = clocks_[i].times;
      if (!at || is_before(times.empty() ? std::nullopt : std::optional(times.back()), *at, time.column)) return;
      for (std::size_t v = 0; v < time.values.size(); ++v) {
        const auto symbol = begin[static_cast<std::ptrdiff_t>(v)];
        const std::string_view cell = rows_.cell(time.values[v]);
        if (!symbol || cell.empty()) continue;
        if (!changes_.take(*symbol, *at, cell, {rows_.line(), time.values[v]})) return;
      }
      times.push_back(*at);
    }
  }

  bool check_empty(const TimeColumn& time) {
    const bool empty = std::all_of(time.values.begin(), time.values.end(),
                                   [&](std::size_t column) { return rows_.cell(column).empty(); });
    if (!empty) fail(time.column, "there are values and no time; write it, or delete the row");
    return empty;
  }

  /// A row with the value of one symbol.
  void take_change() {
    const LongColumns& columns = *layout_.by_row;
    const TimeColumn& time = layout_.times.front();
    const std::string_view name = rows_.cell(columns.symbol);
    if (name.starts_with("$RT_")) return;  // panels of Siemens count rows and note their starts
    if (columns.validity && rows_.cell(*columns.validity) == "0") {
      ++invalid_;
      return;
    }
    if (name.empty()) return fail(columns.symbol, "there is no name of a symbol; write it, or delete the row");
    const std::uint32_t symbol = changes_.symbol(name, {rows_.line(), columns.symbol});
    if (symbol >= long_.size()) long_.resize(symbol + 1, {clocks_[0].reader, {}});
    SymbolClock& clock = long_[symbol];
    const auto at = time_of(time, clock.reader);
    if (!at || is_before(clock.last, *at, time.column)) return;
    const std::string_view cell = rows_.cell(columns.value);
    if (!cell.empty() && !changes_.take(symbol, *at, cell, {rows_.line(), columns.value})) return;
    clock.last = at;
    clocks_[0].times.push_back(*at);
  }

  void finish() {
    if (const std::string wrong = renamer_.same_symbol(changes_.names()); !wrong.empty()) {
      read_.error = fmt::format("{}: {}", read_.recording.name, wrong);
      return;
    }
    if (invalid_ != 0) {
      read_.warnings.push_back(
          fmt::format("{}: rows left out, since their validity is 0: {}", read_.recording.name, invalid_));
    }
    std::vector<Time> ends;
    for (Clock& clock : clocks_) {
      if (layout_.by_row) std::sort(clock.times.begin(), clock.times.end());
      if (clock.times.empty()) continue;
      ends.push_back(clock.times.front());
      ends.push_back(clock.times.back());
    }
    const Time begin = ends.empty() ? 0 : *std::min_element(ends.begin(), ends.end());
    const Time end = ends.empty() ? 0 : *std::max_element(ends.begin(), ends.end());
    if (end / 2 - begin / 2 > kLatestTime / 2) {
      read_.error = fmt::format("{}:{}: the times are over 73 years apart; correct the first or the last one",
                                read_.recording.name, layout_.data_line);
      return;
    }
    for (Clock& clock : clocks_) {
      for (Time& time : clock.times) time -= begin;
    }
    measure();
    read_.recording.end = end - begin;
    changes_.finish(begin);
    if (!options_.renames.empty()) read_.names = changes_.names();
  }

  void measure() {
    for (const Clock& clock : clocks_) {
      const Steps steps = steps_of(clock.times);
      read_.recording.resolution = std::max(read_.recording.resolution, steps.resolution);
      if (clocks_.size() == 1 && !layout_.by_row && steps.regular) {
        read_.recording.gaps = gaps_in(clock.times, steps.resolution);
      }
    }
  }

  /// Of a symbol in a long table.
  struct SymbolClock {
    TimeReader reader;
    std::optional<Time> last;
  };

  ReadRecording& read_;
  std::string_view text_;
  TableLayout layout_;
  TimeForm unit_ = TimeForm::unknown;  ///< that of the options
  const ReadOptions& options_;
  Renamer renamer_;
  TableChanges changes_;
  TableRows rows_;
  std::vector<Clock> clocks_;                          ///< by column of times
  std::vector<std::optional<std::uint32_t>> columns_;  ///< the symbols of all columns of values, by columns of times
  std::vector<SymbolClock> long_;
  std::size_t cells_above_ = 0;
  std::size_t invalid_ = 0;
  bool after_blank_ = false;
  bool ended_ = false;
};

}  // namespace

ReadRecording read_csv(std::istream& file, const std::string& name, const ReadOptions& options) {
  ReadRecording read;
  read.recording.name = name;
  read.recording.of_plant = false;
  const auto text = decoded(whole_text(file), name, read.warnings);
  if (!text) {
    read.error = text.error().message;
    return read;
  }
  TableLayout layout = find_layout(*text, name, options);
  if (!layout.error.empty()) {
    read.error = std::move(layout.error);
    return read;
  }
  TableReader(read, *text, std::move(layout), options).run();
  return read;
}

}  // namespace symplant::recording
