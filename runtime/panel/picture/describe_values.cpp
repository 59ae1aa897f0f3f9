// The description of values for the panel's clients.
#include "symplant/panel/picture/describe_values.hpp"

#include <bit>
#include <cmath>
#include <string_view>
#include <vector>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/value_traces.hpp"

namespace symplant::panel {
namespace {

std::string number_or_null(double number) {
  return std::isfinite(number) ? trace::json_value(tables::DataType::lreal, std::bit_cast<std::uint64_t>(number))
                               : "null";
}

}  // namespace

UnitNames::UnitNames(const trace::PlantNames& names) {
  for (std::uint32_t unit = 0; unit < names.tables().units.size(); ++unit) units_.emplace(names.unit(unit), unit);
  for (std::uint32_t unit = 0; unit < names.tables().units.size(); ++unit) {
    const std::string_view name = names.unit(unit);
    if (const std::size_t dot = name.find('.'); dot != name.npos) units_.emplace(name.substr(0, dot), unit);
  }
}

std::uint32_t UnitNames::of_value(std::string_view value) const {
  for (std::size_t dot = value.rfind('.'); dot != value.npos && dot != 0; dot = value.rfind('.', dot - 1)) {
    if (const auto found = units_.find(value.substr(0, dot)); found != units_.end()) return found->second;
  }
  return tables::kNone;
}

void put_values(std::string& json, const trace::PlantNames& names) {
  const tables::ValueTables& values = names.tables().values;
  const UnitNames units(names);
  const std::vector<std::string_view> texts = tables::split_names(values.formula_texts);
  const std::vector<tables::Time> traces = trace::traces_of(values);
  put_key(json, "values");
  json += '[';
  for (std::uint32_t value = 0; value < values.rows.size(); ++value) {
    const tables::ValueRow& row = values.rows[value];
    for (std::uint32_t output = row.output; output < row.output + row.outputs; ++output) {
      put_comma(json);
      json += '{';
      put_member(json, "name", names.output(output));
      put_member(json, "unit", names.unit_of_value(value));
      put_member(json, "kind", tables::value_kind_name(row.kind));
      put(json, R"(,"min":{},"max":{},"settable":{},"formulas":[)", number_or_null(row.min), number_or_null(row.max),
          tables::keeps_its_output(row.kind));
      for (std::uint32_t formula = row.formula; formula < row.formula + row.formulas; ++formula) {
        put_comma(json);
        put_text(json, texts[formula]);
      }
      put(json, R"(],"device":{},"trace":{}}})", index_or_null(units.of_value(names.value(value)), tables::kNone),
          traces[output] == 0 ? "null" : std::to_string(traces[output]));
    }
  }
  json += ']';
}

}  // namespace symplant::panel
