// The values in the cells of a table.
#include "recording/table_values.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>

#include "text/ascii.hpp"
#include "text/truth.hpp"

namespace symplant::recording {
namespace {

std::optional<double> number_in(std::string_view cell) {
  const char first = cell[cell[0] == '-' && cell.size() > 1 ? 1 : 0];
  if (!text::is_digit(first) && first != '.' && first != ',') return std::nullopt;  // `inf` and `nan` are no values
  std::string with_point;
  if (const std::size_t comma = cell.find(','); comma != cell.npos) {
    with_point = cell;
    with_point[comma] = '.';
    cell = with_point;
  }
  double number = 0;
  const char* const end = cell.data() + cell.size();
  const auto [at, error] = std::from_chars(cell.data(), end, number);
  return error == std::errc() && at == end ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<CellValue> cell_value(std::string_view cell) {
  using Kind = CellValue::Kind;
  if (cell == "0") return CellValue{0, Kind::bit};
  if (cell == "1") return CellValue{1, Kind::bit};
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  if (cell.empty()) return std::nullopt;
  if (const auto number = number_in(cell)) {
    const bool is_bit = *number == 1 || (*number == 0 && !std::signbit(*number));
    return CellValue{*number, is_bit ? Kind::bit : Kind::number};
  }
  if (const auto truth = text::truth_of(cell)) return CellValue{*truth ? 1.0 : 0.0, Kind::word};
  const bool is_on = text::equal_ignoring_case(cell, "ON");
  if (is_on || text::equal_ignoring_case(cell, "OFF")) return CellValue{is_on ? 1.0 : 0.0, Kind::word};
  return std::nullopt;
}

bool is_no_value(std::string_view cell) {
  constexpr std::array<std::string_view, 19> kNoValues{"nan", "-nan", "null", "none",    "nil",   "n/a", "#n/a",
                                                       "na",  "#na",  "inf",  "-inf",    "+inf",  "?",   "-",
                                                       "--",  "---",  "bad",  "invalid", "(null)"};
  return std::any_of(kNoValues.begin(), kNoValues.end(),
                     [&](std::string_view text) { return text::equal_ignoring_case(cell, text); });
}

}  // namespace symplant::recording
