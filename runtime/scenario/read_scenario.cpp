// Reads a scenario file against a plant.
#include "symplant/scenario/read_scenario.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"
#include "symplant/scenario/step_reader.hpp"

namespace symplant::scenario {
namespace {

using Json = nlohmann::json;

constexpr const char* kVersionKey = "symplant-scenario";

/// The fault of a file that is not a scenario of this version; empty for a scenario.
std::optional<json::Fault> another_file(const Json& root) {
  if (!root.is_object()) return std::nullopt;
  if (const auto version = root.find(kVersionKey); version != root.end()) {
    if (!version->is_number_integer() || *version == 1) return std::nullopt;
    return json::Fault{json::child("", kVersionKey),
                       "this scenario has version " + version->dump() + " of the format, this symplant reads version 1",
                       0, false};
  }
  if (!root.contains("symplant")) return std::nullopt;
  return json::Fault{json::child("", "symplant"),
                     "this is a plant description, not a scenario; give it as the plant to run", 0, true};
}

std::vector<json::Fault> shape_faults(const Json& root) {
  if (auto other = another_file(root)) return {std::move(*other)};
  return json::Schema(scenario_schema()).check(root);
}

/// The indexes of steps that do not match the schema and cannot be read.
std::set<std::size_t> broken_steps(std::span<const json::Fault> faults) {
  std::set<std::size_t> broken;
  for (const json::Fault& fault : faults) {
    constexpr std::string_view kSteps = "/steps/";
    if (!fault.pointer.starts_with(kSteps)) continue;
    std::size_t step = 0;
    const char* const begin = fault.pointer.data() + kSteps.size();
    if (std::from_chars(begin, fault.pointer.data() + fault.pointer.size(), step).ec == std::errc())
      broken.insert(step);
  }
  return broken;
}

/// Reads the steps that match the schema, and adds their faults to `faults`.
Scenario read_steps(const Json& steps, StepReader& reader, std::vector<json::Fault>& faults) {
  const std::set<std::size_t> broken = broken_steps(faults);
  Scenario scenario;
  scenario.steps.reserve(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!broken.contains(i)) scenario.steps.push_back(reader.read(steps[i], json::child("/steps", i)));
  }
  std::move(reader.faults.begin(), reader.faults.end(), std::back_inserter(faults));
  return scenario;
}

/// Sets the lines of the steps: locates them as faults, in one pass over the text.
void find_lines(std::string_view text, Scenario& scenario) {
  std::vector<json::Fault> indexes(scenario.steps.size());
  for (std::size_t i = 0; i < indexes.size(); ++i) indexes[i].pointer = json::child("/steps", i);
  const std::vector<json::Span> spans = json::spans(text, indexes);
  std::size_t line = 1;
  std::size_t at = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::max(at, spans[i].begin));
    line += static_cast<std::size_t>(std::count(begin, end, '\n'));
    at = std::max(at, spans[i].begin);
    scenario.steps[i].line = line;
  }
}

}  // namespace

ReadScenario read_scenario(std::string_view text, const trace::PlantNames& names, const std::vector<bool>& carried) {
  ReadScenario result;
  json::Document document = json::parse(text);
  result.faults = std::move(document.faults);
  if (!document.root) return result;
  const Json& root = *document.root;
  std::vector<json::Fault> faults = shape_faults(root);
  if (root.is_object() && root.contains("steps") && root["steps"].is_array() && !another_file(root)) {
    StepReader reader(names, carried);
    Scenario scenario = read_steps(root["steps"], reader, faults);
    if (faults.empty() && result.faults.empty()) {
      find_lines(text, scenario);
      result.scenario = std::move(scenario);
      return result;
    }
  }
  for (json::Placed& placed : json::locate(text, faults)) result.faults.push_back(std::move(placed));
  std::stable_sort(result.faults.begin(), result.faults.end(),
                   [](const json::Placed& a, const json::Placed& b) { return a.span.begin < b.span.begin; });
  return result;
}

}  // namespace symplant::scenario
