// Comma-separated values.
#include "symplant/trace/csv_text.hpp"

#include "symplant/tables/duration.hpp"

namespace symplant::trace {

std::string csv_cell(std::string_view text) {
  constexpr std::string_view kBeginsFormula = "=+-@\t\r";
  std::string cell;
  if (!text.empty() && kBeginsFormula.find(text.front()) != kBeginsFormula.npos) cell += '\'';
  cell += text;
  if (cell.find_first_of(",;\"\n\r") == cell.npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_seconds(tables::Time time) {
  if (time < 0) return "-";
  std::string text = tables::duration_text(time);
  text.pop_back();  // the unit
  return text;
}

}  // namespace symplant::trace
