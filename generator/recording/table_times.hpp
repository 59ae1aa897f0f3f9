// The times in the cells of a table.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::recording {

/// How a column gives times.
enum class TimeForm : std::uint8_t {
  unknown,
  s,
  ms,
  us,
  ns,
  filetime,     ///< 100 ns since 1601
  day_million,  ///< millionths of a day since 1899, as panels of Siemens write it
  calendar,     ///< a date, a time of day or both
};

/// A unit as headers and --time-unit have it: `ms`, `[ms]`, `seconds`. unknown if the text is no unit.
TimeForm time_form_of(std::string_view unit);

/// `ms`, `FILETIME`, `millionths of a day`, `dates`: for messages.
std::string_view words_of(TimeForm form);

/// The form that a cell shows by itself: a date or time of day, a number that only a clock has, a number with decimals
/// (s). unknown for other numbers and other texts.
TimeForm time_form_in(std::string_view cell);

/// Whether a cell can be a time in any form. O(cell).
bool is_time(std::string_view cell);

/// Reads the cells of one column of times, from top to bottom. Not thread-safe.
class TimeReader {
 public:
  explicit TimeReader(TimeForm form = TimeForm::unknown) : form_(form) {}

  TimeForm form() const { return form_; }
  /// The time in ns since a time that is the same for all cells: 1970 for dates, FILETIME and panels of Siemens.
  /// Nothing with error() if the cell is no time. O(cell).
  std::optional<tables::Time> read(std::string_view cell);
  /// The same for a date and a time of day in two cells.
  std::optional<tables::Time> read(std::string_view date, std::string_view time_of_day);
  /// What a cell that read() rejected should be: "write ...".
  const std::string& error() const { return error_; }

 private:
  enum class Order : std::uint8_t { unknown, day_first, month_first };
  struct Date {
    int first = 0;
    int second = 0;
    int year = 0;
    bool operator==(const Date&) const = default;
  };

  std::optional<tables::Time> calendar(std::string_view cell);
  std::optional<std::int64_t> day_of(std::string_view date);
  std::optional<std::int64_t> day_in_order(const Date& date);

  TimeForm form_;
  Order order_ = Order::unknown;                  ///< of dates such as 3/4/2024
  std::optional<Date> first_date_;                ///< with the month first, if it can be
  std::int64_t day_shift_ = 0;                    ///< from a date with the day first to that of first_date_
  std::optional<tables::Time> last_time_of_day_;  ///< of times without a date
  std::int64_t midnights_ = 0;                    ///< passed by them
  std::string last_date_;                         ///< as it is in the file
  std::int64_t last_day_ = 0;
  std::string error_;
};

}  // namespace symplant::recording
