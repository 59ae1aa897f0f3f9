// Results as lines of JSON, and the names of classes.
#include "campaign/result.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace symplant::campaign {
namespace {

using Json = nlohmann::ordered_json;

struct ClassRow {
  Class is;
  std::string_view name;
  int rank;
};
constexpr std::array<ClassRow, kClasses> kRows{{{Class::error, "error", 0},
                                                {Class::violated, "violated", 1},
                                                {Class::no_effect, "no effect", 6},
                                                {Class::detected, "detected", 5},
                                                {Class::undetected, "undetected", 2},
                                                {Class::stopped, "stopped", 3},
                                                {Class::other, "other", 4}}};

const ClassRow& row_of(Class one) { return kRows[static_cast<std::size_t>(one)]; }

/// Whether a page can show it: null, or what chart_of() makes.
bool is_chart(const Json& chart) {
  if (chart.is_null()) return true;
  const auto is_series = [](const Json& one) {
    return one.is_object() && one.contains("name") && one["name"].is_string() && one.contains("base") &&
           one["base"].is_array() && one.contains("run") && one["run"].is_array();
  };
  return chart.is_object() && chart.contains("series") && chart["series"].is_array() &&
         std::all_of(chart["series"].begin(), chart["series"].end(), is_series) && chart.contains("differences") &&
         chart["differences"].is_array() && chart.contains("end") && chart["end"].is_number() &&
         chart.contains("left_out") && chart["left_out"].is_number() && chart.contains("cut") &&
         chart["cut"].is_boolean();
}

}  // namespace

std::string_view class_name(Class one) { return row_of(one).name; }

std::optional<Class> class_of(std::string_view name) {
  std::string blanks(name);
  std::replace(blanks.begin(), blanks.end(), '-', ' ');
  const auto found = std::find_if(kRows.begin(), kRows.end(), [&](const ClassRow& row) { return row.name == blanks; });
  return found == kRows.end() ? std::nullopt : std::optional(found->is);
}

int rank(Class one) { return row_of(one).rank; }

std::string Result::title() const { return item + " " + mode + ", " + phase; }

std::string Result::line() const {
  const Json json{{"item", item},
                  {"more", more},
                  {"mode", mode},
                  {"phase", phase},
                  {"at", at},
                  {"class", class_name(is)},
                  {"seen", seen},
                  {"seen_at", seen_at},
                  {"reaction", reaction},
                  {"requirement", requirement},
                  {"violated_at", violated_at},
                  {"failed_step", failed_step},
                  {"alarms", alarms},
                  {"detection", detection},
                  {"on", on},
                  {"end", end},
                  {"command", command},
                  {"ran", ran}};
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.substr(0, text.size() - 1) + ",\"chart\":" + chart + "}";
}

std::optional<Result> Result::of_line(std::string_view line) try {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto is = class_of(json.at("class").get<std::string>());
  if (!is || !is_chart(json.at("chart"))) return std::nullopt;
  for (const char* const time : {"at", "seen_at", "violated_at", "detection"}) {
    if (!json.at(time).is_number_integer() || json.at(time).get<tables::Time>() < -1) return std::nullopt;
  }
  return Result{json.at("item"),        json.at("more"),        json.at("mode"),
                json.at("phase"),       json.at("at"),          *is,
                json.at("seen"),        json.at("seen_at"),     json.at("reaction"),
                json.at("requirement"), json.at("violated_at"), json.at("failed_step"),
                json.at("alarms"),      json.at("detection"),   json.at("on"),
                json.at("end"),         json.at("command"),     json.at("chart").dump(),
                json.at("ran")};
} catch (const Json::exception&) {
  return std::nullopt;
}

}  // namespace symplant::campaign
