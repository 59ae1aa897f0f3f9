// The times in the cells of a table.
#include "recording/table_times.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>

#include "text/ascii.hpp"

namespace symplant::recording {
namespace {

using tables::Time;

constexpr std::int64_t kFileTimeOf1970 = 116'444'736'000'000'000;
constexpr std::int64_t kDaysTo1970 = 25'569;  // since 1899-12-30, as spreadsheets count
constexpr Time kSecond = 1'000'000'000;
constexpr Time kDay = 86'400 * kSecond;

struct UnitWord {
  std::string_view word;
  TimeForm form;
};
constexpr std::array<UnitWord, 27> kUnitWords{{
    {"s", TimeForm::s},
    {"sec", TimeForm::s},
    {"secs", TimeForm::s},
    {"second", TimeForm::s},
    {"seconds", TimeForm::s},
    {"sek", TimeForm::s},
    {"sekunden", TimeForm::s},
    {"ms", TimeForm::ms},
    {"msec", TimeForm::ms},
    {"msecs", TimeForm::ms},
    {"millis", TimeForm::ms},
    {"millisecond", TimeForm::ms},
    {"milliseconds", TimeForm::ms},
    {"millisekunden", TimeForm::ms},
    {"us", TimeForm::us},
    {"\xC2\xB5s", TimeForm::us},
    {"\xCE\xBCs", TimeForm::us},
    {"usec", TimeForm::us},
    {"usecs", TimeForm::us},
    {"microsecond", TimeForm::us},
    {"microseconds", TimeForm::us},
    {"ns", TimeForm::ns},
    {"nsec", TimeForm::ns},
    {"nanosecond", TimeForm::ns},
    {"nanoseconds", TimeForm::ns},
    {"filetime", TimeForm::filetime},
    {"iso", TimeForm::calendar},
}};

/// A decimal number in the text: its digits before and after the point, as far as they count.
struct Decimal {
  bool negative = false;
  std::int64_t whole = 0;
  std::int64_t fraction = 0;  ///< in 10^-9
};

/// Takes a whole number without a sign off the text. False without a number, or if it is too large.
template <class Number>
bool take_digits(std::string_view& text, Number& number) {
  if (text.empty() || !text::is_digit(text[0])) return false;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

/// Takes a fraction off the text, in 10^-9; further digits do not count.
std::int64_t take_fraction(std::string_view& text) {
  std::int64_t fraction = 0;
  std::int64_t unit = kSecond;
  while (!text.empty() && text::is_digit(text[0])) {
    if (unit > 1) fraction += (unit /= 10) * (text[0] - '0');
    text.remove_prefix(1);
  }
  return fraction;
}

bool is_point(std::string_view text) { return !text.empty() && (text[0] == '.' || text[0] == ','); }

bool take(std::string_view& text, char c) {
  if (text.empty() || text[0] != c) return false;
  text.remove_prefix(1);
  return true;
}

/// Nothing if the text is no plain decimal number, or too large.
std::optional<Decimal> decimal_of(std::string_view text) {
  Decimal decimal;
  decimal.negative = take(text, '-');
  if (!decimal.negative) take(text, '+');
  const bool begins_with_point = text.size() > 1 && is_point(text);
  if (!begins_with_point && !take_digits(text, decimal.whole)) return std::nullopt;
  if (is_point(text)) {
    text.remove_prefix(1);
    decimal.fraction = take_fraction(text);
  }
  return text.empty() ? std::optional(decimal) : std::nullopt;
}

/// A number with an exponent, as scopes write it.
std::optional<double> number_with_exponent(std::string_view text) {
  if (text.find_first_of("eE") == text.npos) return std::nullopt;
  std::string with_point(text);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  text = with_point;
  take(text, '+');
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && at == end && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

bool is_number(std::string_view text) { return decimal_of(text) || number_with_exponent(text); }

Time ns_of(TimeForm form) {
  switch (form) {
    case TimeForm::s:
      return kSecond;
    case TimeForm::ms:
      return 1'000'000;
    case TimeForm::us:
      return 1'000;
    case TimeForm::filetime:
      return 100;
    case TimeForm::day_million:
      return kDay / 1'000'000;
    default:
      return 1;
  }
}

/// The number that is 1970, if numbers of a form count from an earlier time.
std::int64_t begin_of(TimeForm form, double number) {
  if (form == TimeForm::filetime) return number >= static_cast<double>(kFileTimeOf1970) ? kFileTimeOf1970 : 0;
  return form == TimeForm::day_million ? kDaysTo1970 * 1'000'000 : 0;
}

std::optional<Time> scaled(std::string_view cell, TimeForm form) {
  const Time unit = ns_of(form);
  const auto decimal = decimal_of(cell);
  if (!decimal) {
    const auto number = number_with_exponent(cell);
    const double time =
        number ? (*number - static_cast<double>(begin_of(form, *number))) * static_cast<double>(unit) : 0;
    constexpr double kMost = 9e18;
    return number && std::abs(time) < kMost ? std::optional(static_cast<Time>(std::llround(time))) : std::nullopt;
  }
  const std::int64_t whole =
      (decimal->negative ? -decimal->whole : decimal->whole) - begin_of(form, static_cast<double>(decimal->whole));
  constexpr Time kMost = std::numeric_limits<Time>::max() - kDay;
  if (whole > kMost / unit || whole < -kMost / unit) return std::nullopt;
  const Time part =
      static_cast<Time>(std::llround(static_cast<double>(decimal->fraction) / 1e9 * static_cast<double>(unit)));
  return whole * unit + (decimal->negative ? -part : part);
}

/// Days from 1970-01-01 to a date of the Gregorian calendar (H. Hinnant, "chrono-compatible low-level date
/// algorithms").
std::int64_t days_to(int year, int month, int day) {
  const int shifted = year - (month <= 2 ? 1 : 0);
  const int era = (shifted >= 0 ? shifted : shifted - 399) / 400;
  const int of_era = shifted - era * 400;
  const int of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return std::int64_t{era} * 146'097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719'468;
}

bool is_date(int year, int month, int day) {
  if (year < 1970 || year > 2260 || month < 1 || month > 12 || day < 1) return false;
  const int next = month == 12 ? 1 : month + 1;
  return day <= days_to(month == 12 ? year + 1 : year, next, 1) - days_to(year, month, 1);
}

struct Parts {
  std::string_view date;
  std::string_view time_of_day;
};

/// The date and the time of day of a cell; either may be empty.
Parts parts_of(std::string_view cell) {
  const std::size_t colon = cell.find(':');
  if (colon == cell.npos) return {cell, {}};
  const std::size_t before = cell.find_last_of(" T", colon);
  if (before == cell.npos) return {{}, cell};
  std::string_view date = cell.substr(0, before);
  while (!date.empty() && (date.back() == ' ' || date.back() == ',')) date.remove_suffix(1);
  return {date, cell.substr(before + 1)};
}

void take_blanks(std::string_view& text) {
  while (take(text, ' ')) {
  }
}

bool take_word(std::string_view& text, std::string_view word) {
  if (!text::equal_ignoring_case(text.substr(0, word.size()), word)) return false;
  text.remove_prefix(word.size());
  return true;
}

/// Takes a zone such as `Z`, `UTC`, `+01:00` or `+01` off the text. Its distance to UTC; nothing if it is wrong.
std::optional<Time> take_zone(std::string_view& text) {
  if (take_word(text, "UTC") || take_word(text, "GMT") || take_word(text, "Z") || text.empty()) return 0;
  const bool west = take(text, '-');
  if (!west && !take(text, '+')) return std::nullopt;
  const std::string_view hour_digits = text.substr(0, 2);
  std::string_view minute_digits = text.substr(std::min<std::size_t>(2, text.size()));
  take(minute_digits, ':');
  int hours = 0;
  int minutes = 0;
  std::string_view rest = hour_digits;
  if (rest.size() != 2 || !take_digits(rest, hours) || !rest.empty()) return std::nullopt;
  if (!minute_digits.empty() && (minute_digits.size() != 2 || !take_digits(minute_digits, minutes)))
    return std::nullopt;
  if (hours > 15 || minutes > 59) return std::nullopt;
  text = {};
  const Time distance = (hours * 60 + minutes) * 60 * kSecond;
  return west ? -distance : distance;
}

/// The half of the day that `AM` or `PM` at the text gives to an hour. False if there is no such hour.
bool take_half_day(std::string_view& text, int& hour) {
  const bool pm = take_word(text, "PM");
  if (!pm && !take_word(text, "AM")) return hour < 24;
  if (hour < 1 || hour > 12) return false;
  hour = hour % 12 + (pm ? 12 : 0);
  return true;
}

/// The time since midnight UTC.
std::optional<Time> since_midnight(std::string_view text) {
  int hour = 0;
  int minute = 0;
  int second = 0;
  if (!take_digits(text, hour) || !take(text, ':') || !take_digits(text, minute)) return std::nullopt;
  if (take(text, ':') && !take_digits(text, second)) return std::nullopt;
  Time fraction = 0;
  if (is_point(text)) {
    text.remove_prefix(1);
    fraction = take_fraction(text);
  }
  take_blanks(text);
  if (!take_half_day(text, hour) || minute > 59 || second > 60) return std::nullopt;
  take_blanks(text);
  const auto zone = take_zone(text);
  if (!zone || !text.empty()) return std::nullopt;
  return ((hour * 60 + minute) * 60 + second) * kSecond + fraction - *zone;
}

constexpr const char* kIsoExample = "2024-12-31T23:59:59.5";

}  // namespace

std::string_view words_of(TimeForm form) {
  switch (form) {
    case TimeForm::s:
      return "s";
    case TimeForm::ms:
      return "ms";
    case TimeForm::us:
      return "us";
    case TimeForm::ns:
      return "ns";
    case TimeForm::filetime:
      return "FILETIME";
    case TimeForm::day_million:
      return "millionths of a day";
    case TimeForm::calendar:
      return "dates";
    case TimeForm::unknown:
      break;
  }
  return "a unit that is not known";
}

TimeForm time_form_of(std::string_view unit) {
  const auto found = std::find_if(kUnitWords.begin(), kUnitWords.end(),
                                  [&](const UnitWord& one) { return text::equal_ignoring_case(one.word, unit); });
  return found == kUnitWords.end() ? TimeForm::unknown : found->form;
}

TimeForm time_form_in(std::string_view cell) {
  if (number_with_exponent(cell)) return TimeForm::s;
  const auto decimal = decimal_of(cell);
  if (!decimal) {
    TimeReader reader(TimeForm::calendar);
    return reader.read(cell) ? TimeForm::calendar : TimeForm::unknown;
  }
  constexpr std::int64_t kClock = 1'000'000'000;  // s since 1970, in 2001
  const std::int64_t whole = decimal->whole;
  if (whole >= kClock * kClock) return TimeForm::ns;
  if (whole >= kFileTimeOf1970) return TimeForm::filetime;
  if (whole >= kClock * 1'000'000) return TimeForm::us;
  if (whole >= kClock * 1'000) return TimeForm::ms;
  return whole >= kClock || cell.find_first_of(".,") != cell.npos ? TimeForm::s : TimeForm::unknown;
}

bool is_time(std::string_view cell) { return is_number(cell) || TimeReader(TimeForm::calendar).read(cell); }

std::optional<Time> TimeReader::read(std::string_view cell) {
  if (form_ == TimeForm::calendar) return calendar(cell);
  auto time = scaled(cell, form_);
  if (!time) error_ = "write a number";
  return time;
}

std::optional<Time> TimeReader::read(std::string_view date, std::string_view time_of_day) {
  const auto day = day_of(date);
  if (!day) return std::nullopt;
  const auto time = since_midnight(time_of_day);
  if (!time) error_ = "write a date and a time of day, such as 2024-12-31 and 23:59:59.5";
  return time ? std::optional(*day * kDay + *time) : std::nullopt;
}

std::optional<Time> TimeReader::calendar(std::string_view cell) {
  const Parts parts = parts_of(cell);
  std::optional<std::int64_t> day = 0;
  if (!parts.date.empty()) day = day_of(parts.date);
  if (!day) return std::nullopt;
  const auto time = parts.time_of_day.empty() ? std::optional<Time>(0) : since_midnight(parts.time_of_day);
  if (!time || cell.empty()) {
    error_ = std::string("write a time such as ") + (parts.date.empty() ? "23:59:59.5" : kIsoExample);
    return std::nullopt;
  }
  if (!parts.date.empty()) return *day * kDay + *time;
  if (last_time_of_day_ && *time < *last_time_of_day_ - kDay / 2) ++midnights_;
  last_time_of_day_ = time;
  return midnights_ * kDay + *time;
}

std::optional<std::int64_t> TimeReader::day_of(std::string_view date) {
  if (date == last_date_ && !date.empty()) return last_day_;
  std::string_view text = date;
  int numbers[3]{};
  char separator = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == 1 && !text.empty()) separator = text[0];
    const bool separated =
        i == 0 || ((separator == '-' || separator == '/' || separator == '.') && take(text, separator));
    if (!separated || !take_digits(text, numbers[i])) {
      error_ = std::string("write a time such as ") + kIsoExample;
      return std::nullopt;
    }
  }
  if (!text.empty()) {
    error_ = std::string("write a time such as ") + kIsoExample;
    return std::nullopt;
  }
  std::optional<std::int64_t> day;
  const auto [first, second, third] = numbers;
  const int year = third >= 100 ? third : third + (third >= 70 ? 1900 : 2000);
  if (first >= 100) {
    if (is_date(first, second, third)) day = days_to(first, second, third);
  } else if (separator == '.') {
    if (is_date(year, second, first)) day = days_to(year, second, first);
  } else {
    day = day_in_order({first, second, year});
    if (!day && !error_.empty()) return std::nullopt;
  }
  if (!day) {
    error_ = std::string("there is no such day; write a time such as ") + kIsoExample;
    return std::nullopt;
  }
  last_date_ = date;
  last_day_ = *day;
  return day;
}

/// Of a date such as 3/4/2024 it is not known which number is the month. The first one counts as if it were the first
/// number; a second one decides, if it can.
std::optional<std::int64_t> TimeReader::day_in_order(const Date& date) {
  error_.clear();
  const auto day_if = [](const Date& one, Order order) -> std::optional<std::int64_t> {
    const int month = order == Order::day_first ? one.second : one.first;
    const int day = order == Order::day_first ? one.first : one.second;
    return is_date(one.year, month, day) ? std::optional(days_to(one.year, month, day)) : std::nullopt;
  };
  const auto day_first = day_if(date, Order::day_first);
  const auto month_first = day_if(date, Order::month_first);
  if (order_ == Order::month_first) return month_first;
  if (order_ == Order::day_first) return day_first ? std::optional(*day_first + day_shift_) : std::nullopt;
  if (!first_date_) {
    first_date_ = date;
    if (!day_first || !month_first) order_ = day_first ? Order::day_first : Order::month_first;
    return month_first ? month_first : day_first;
  }
  if (date == *first_date_) return month_first;
  const auto a = day_if(*first_date_, Order::day_first);
  const auto b = day_if(*first_date_, Order::month_first);
  const bool can_be_days = day_first && a && (!month_first || *day_first - *a == 1);
  const bool can_be_months = month_first && b && (!day_first || *month_first - *b == 1);
  if (can_be_days == can_be_months) {
    error_ = "it is not known which number is the month; write dates such as 2024-12-31";
    return std::nullopt;
  }
  if (can_be_months) {
    order_ = Order::month_first;
    return month_first;
  }
  order_ = Order::day_first;
  day_shift_ = *b - *a;
  return *day_first + day_shift_;
}

}  // namespace symplant::recording
