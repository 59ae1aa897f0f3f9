// Reads the queries of requests.
#pragma once

#include <charconv>
#include <map>
#include <string>
#include <string_view>
#include <system_error>

#include "symplant/panel/picture/chart.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

inline constexpr std::string_view kChartForm =
    "a chart has at most 32 `symbols`, `devices` and `values` by their indexes, and times `from`, `to`, or numbers "
    "`after`, `after_value`";

/// Reads a number >= 0; `well` becomes false if the text is not one. Without the key the number stays.
template <class Number>
void read_number(const std::map<std::string, std::string>& query, const char* key, Number& number, bool& well) {
  const auto found = query.find(key);
  if (found == query.end()) return;
  const std::string& text = found->second;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  well = well && error == std::errc() && end == text.data() + text.size() && number >= 0;
}

/// False if the query is not of the form kChartForm.
bool read_chart(const std::map<std::string, std::string>& query, const trace::PlantNames& names, ChartWish& wish);

}  // namespace symplant::panel
