// The doctor's report for people and as JSON.
#include "app/doctor_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

#include "diag/visible_text.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::app {
namespace {

using link::doctor::Point;
using link::doctor::Report;
using link::doctor::Result;
using link::doctor::Step;

std::string_view result_name(Result result) {
  constexpr std::array<std::string_view, 4> kNames = {"good", "warning", "bad", "skipped"};
  return kNames[static_cast<std::size_t>(result)];
}

bool is_finding(Result result) { return result == Result::warning || result == Result::bad; }

std::string_view direction_name(const tables::SymbolRow& symbol) {
  return symbol.direction() == tables::Direction::operation ? "operation" : "event";
}

/// Two texts for each symbol: name, address.
std::string_view name_of(const std::vector<std::string_view>& texts, std::uint32_t symbol) {
  return texts[std::size_t{2} * symbol];
}

}  // namespace

bool has_findings(const Report& report) {
  return std::any_of(report.steps.begin(), report.steps.end(), [](const Step& s) { return is_finding(s.result); }) ||
         std::any_of(report.points.begin(), report.points.end(), [](const Point& p) { return is_finding(p.result); });
}

std::string doctor_text(const Report& report, const tables::PlantTables& tables, bool all) {
  std::string text = fmt::format("link {}\n", diag::visible(report.url));
  const auto out = std::back_inserter(text);
  for (const Step& step : report.steps) {
    fmt::format_to(out, "{:<8} {}: {}\n", result_name(step.result), step.name, diag::visible(step.text));
  }
  const auto texts = tables::split_names(tables.symbol_names);
  for (const Point& point : report.points) {
    if (!all && !is_finding(point.result)) continue;
    const tables::SymbolRow& symbol = tables.symbols[point.symbol];
    fmt::format_to(out, "{:<8} {} {}{}{}{}{}\n", result_name(point.result), direction_name(symbol),
                   diag::visible(name_of(texts, point.symbol)), point.address.empty() ? "" : " at " + point.address,
                   point.value ? " is " + trace::value_text(symbol, *point.value) : "", point.text.empty() ? "" : ": ",
                   diag::visible(point.text));
  }
  return text;
}

std::string doctor_json(const Report& report, const tables::PlantTables& tables) {
  using trace::json_string;
  std::string text =
      fmt::format(R"({{"symplant-doctor":1,"plant":{},"link":{},"reached":{},"findings":{},"steps":[)",
                  json_string(tables.name), json_string(report.url), report.reached, has_findings(report));
  const auto out = std::back_inserter(text);
  for (const Step& step : report.steps) {
    fmt::format_to(out, R"({}{{"step":{},"result":"{}","text":{}}})", &step == report.steps.data() ? "" : ",",
                   json_string(step.name), result_name(step.result), json_string(step.text));
  }
  text += "],\"points\":[";
  const auto texts = tables::split_names(tables.symbol_names);
  for (const Point& point : report.points) {
    const tables::SymbolRow& symbol = tables.symbols[point.symbol];
    fmt::format_to(out, R"({}{{"symbol":{},"direction":"{}","address":{},"result":"{}","value":{},"text":{}}})",
                   &point == report.points.data() ? "" : ",", json_string(name_of(texts, point.symbol)),
                   direction_name(symbol), point.address.empty() ? "null" : json_string(point.address),
                   result_name(point.result), point.value ? trace::json_value(symbol.type(), *point.value) : "null",
                   json_string(point.text));
  }
  return text + "]}\n";
}

}  // namespace symplant::app
