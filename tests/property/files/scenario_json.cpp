// A scenario as a file.
#include "property/files/scenario_json.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "property/files/json_printer.hpp"
#include "property/files/said.hpp"

namespace symplant::property::files {
namespace {

using nlohmann::json;

class ScenarioWriter {
 public:
  ScenarioWriter(const model::PlantModel& plant, const Style& style, Counts& counts)
      : sayer_(style, "scenario", counts) {
    for (const model::Symbol& symbol : plant.symbols) types_.emplace(symbol.name(), symbol.type);
  }

  json step(const Step& step) {
    json said = json::object();
    if (step.when == Step::When::wait) {
      said["wait"] = sayer_.condition(step.wait);
      if (step.time) said["within"] = sayer_.time(*step.time);
    } else {
      said[step.when == Step::When::at ? "at" : "plus"] = sayer_.time(*step.time);
    }
    if (!step.set.empty()) said["set"] = settings(step.set);
    for (const auto& [device, state] : step.states) said["state"][sayer_.name(device)] = sayer_.name(state);
    if (!step.put.empty()) said["put"] = puts(step);
    if (!step.take.empty()) said["take"] = takes(step);
    if (!step.force.empty()) said["force"] = settings(step.force);
    for (const std::string& symbol : step.release) said["release"].push_back(sayer_.name(symbol));
    if (!step.stop.empty()) said["stop"] = names(step.stop);
    if (!step.start.empty()) said["start"] = names(step.start);
    if (!step.expect.empty()) said["expect"] = settings(step.expect);
    if (!step.expect_condition.empty()) said["expect"] = sayer_.condition(step.expect_condition);
    return said;
  }

 private:
  /// One without a list, perhaps.
  json listed(json list) {
    if (list.size() == 1 && sayer_.dice.percent(70)) return list.front();
    return list;
  }

  json puts(const Step& step) {
    json all = json::array();
    for (const auto& [at, kind] : step.put) all.push_back({{"at", sayer_.location(at)}, {"kind", sayer_.name(kind)}});
    return listed(std::move(all));
  }

  json takes(const Step& step) {
    json all = json::array();
    for (const std::string& from : step.take) all.push_back(sayer_.location(from));
    return listed(std::move(all));
  }

  json names(const std::vector<std::string>& names) {
    json all = json::array();
    for (const std::string& name : names) all.push_back(sayer_.name(name));
    return listed(std::move(all));
  }

  json settings(const std::vector<Setting>& settings) {
    json said = json::object();
    for (const auto& [symbol, value] : settings) said[sayer_.name(symbol)] = number(types_.at(symbol), value);
    return said;
  }

  json number(tables::DataType type, std::uint64_t value) {
    if (type == tables::DataType::boolean) return value != 0;
    if (type == tables::DataType::real || type == tables::DataType::lreal) return real(std::bit_cast<double>(value));
    const bool is_signed = type >= tables::DataType::sint && type <= tables::DataType::lint;
    const json number = is_signed ? json(static_cast<std::int64_t>(value)) : json(value);
    if (sayer_.dice.percent(5)) return number.dump();  // as a trace writes large ones
    return number;
  }

  json real(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (value > 0 && value == std::floor(value) && sayer_.dice.percent(50)) return static_cast<int>(value);
    return value;
  }

  Sayer sayer_;
  std::unordered_map<std::string_view, tables::DataType> types_;
};

/// Steps that come several times, one turn after the other.
struct Run {
  std::size_t length = 1;
  std::size_t turns = 1;
};

Run run_at(const std::vector<Step>& steps, std::size_t at) {
  for (std::size_t length = 1; at + 2 * length <= steps.size() && length <= 4; ++length) {
    const auto begin = steps.begin() + static_cast<std::ptrdiff_t>(at);
    const auto size = static_cast<std::ptrdiff_t>(length);
    if (std::any_of(begin, begin + size, [](const Step& step) { return step.when == Step::When::at; })) break;
    std::size_t turns = 1;
    while (at + (turns + 1) * length <= steps.size() &&
           std::equal(begin, begin + size, begin + static_cast<std::ptrdiff_t>(turns) * size)) {
      ++turns;
    }
    if (turns > 1) return {length, turns};
  }
  return {};
}

}  // namespace

std::vector<std::size_t> numbers_in_file(const std::vector<Step>& steps) {
  std::vector<std::size_t> numbers;
  std::size_t next = 0;
  while (numbers.size() < steps.size()) {
    const Run run = run_at(steps, numbers.size());
    for (std::size_t i = 0; i < run.length * run.turns; ++i) numbers.push_back(next + i % run.length);
    next += run.length;
  }
  return numbers;
}

std::string scenario_json(const std::vector<Step>& steps, const model::PlantModel& plant, const Style& style,
                          Counts& counts) {
  ScenarioWriter writer(plant, style, counts);
  json said = {{"symplant-scenario", 1}, {"steps", json::array()}};
  for (std::size_t at = 0; at < steps.size();) {
    const Run run = run_at(steps, at);
    json turn = json::array();
    for (std::size_t i = at; i < at + run.length; ++i) turn.push_back(writer.step(steps[i]));
    at += run.length * run.turns;
    if (run.turns == 1) {
      said["steps"].push_back(turn.front());
    } else {
      said["steps"].push_back({{"repeat", run.turns}, {"steps", turn}});
      ++counts[Seen::repeats];
    }
  }
  return print_json(said, style.decorated, Dice(style.seed + 1), counts[Seen::comments]);
}

}  // namespace symplant::property::files
