// Looks up the names of a scenario's steps, as simply as possible.
#include "property/files/resolved_steps.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include "property/part_differences.hpp"
#include "support/reference/lines.hpp"
#include "support/reference/rules.hpp"
#include "symplant/condition/resolve.hpp"

namespace symplant::property::files {
namespace {

using reference::same_name;

class PlainNames final : public condition::Names {
 public:
  explicit PlainNames(const model::PlantModel& plant) : plant_(plant) {}

  std::optional<std::uint32_t> unit(std::string_view device, std::string_view facet) const override {
    const std::string wanted = std::string(device) + (facet.empty() ? "" : ".") + std::string(facet);
    for (std::uint32_t i = 0; i < plant_.units.size(); ++i) {
      if (same_name(plant_.units[i].path, wanted)) return i;
    }
    return std::nullopt;
  }
  std::vector<std::uint32_t> facets(std::string_view device) const override {
    std::vector<std::uint32_t> units;
    for (std::uint32_t i = 0; i < plant_.units.size(); ++i) {
      const std::string_view path = plant_.units[i].path;
      if (same_name(path.substr(0, path.rfind('.')), device) && path.find('.') != path.npos) units.push_back(i);
    }
    return units;
  }
  std::string path(std::uint32_t unit) const override { return std::string(plant_.units[unit].path); }
  std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const override {
    const auto& states = plant_.units[unit].states;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (same_name(states[i].name, name)) return static_cast<std::uint8_t>(i);
    }
    return std::nullopt;
  }
  std::optional<Symbol> symbol(std::string_view name) const override {
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (same_name(plant_.symbols[i].name(), name)) return Symbol{i, plant_.symbols[i].type};
    }
    return std::nullopt;
  }
  std::optional<std::uint32_t> location(std::string_view name) const override {
    const model::Material& material = plant_.material;
    for (std::uint32_t i = 0; i < material.locations(); ++i) {
      if (same_name(material.location_name(i), name)) return i;
    }
    return std::nullopt;
  }
  std::optional<std::uint32_t> part_kind(std::string_view name) const override {
    for (std::uint32_t i = 0; i < plant_.material.kinds.size(); ++i) {
      if (same_name(plant_.material.kinds[i].name, name)) return i;
    }
    return std::nullopt;
  }
  // Messages are not used here.
  std::string nearest_device(std::string_view, std::string_view) const override { return {}; }
  std::string nearest_state(std::uint32_t, std::string_view) const override { return {}; }
  std::string nearest_symbol(std::string_view) const override { return {}; }
  std::string why_no_state(std::uint32_t, std::string_view) const override { return {}; }

 private:
  const model::PlantModel& plant_;
};

}  // namespace

const condition::Tree* StepResolver::condition(const std::string& text) {
  const auto [known, is_new] = conditions_.try_emplace(text, nullptr);
  if (!is_new) return known->second;
  auto parsed = condition::parse_and_resolve(text, PlainNames(plant_));
  if (auto* tree = std::get_if<condition::Tree>(&parsed)) known->second = &trees_.emplace_back(std::move(*tree));
  return known->second;
}

bool StepResolver::settings(const std::vector<Setting>& from,
                            std::vector<std::pair<std::uint32_t, std::uint64_t>>& to) const {
  const PlainNames names(plant_);
  for (const auto& [name, value] : from) {
    const auto symbol = names.symbol(name);
    if (!symbol) return false;
    to.emplace_back(symbol->index, value);
  }
  return true;
}

bool StepResolver::malfunctions(const std::vector<std::string>& names, std::vector<std::uint32_t>& to) const {
  const std::size_t all = plant_.malfunctions.size() + 2 * plant_.units.size() + 2 * plant_.symbols.size();
  for (const std::string& name : names) {
    std::uint32_t number = 0;
    while (number < all && !same_name(reference::malfunction_name(plant_, number), name)) ++number;
    if (number == all) return false;
    to.push_back(number);
  }
  return true;
}

std::optional<reference::ScenarioStep> StepResolver::resolve(const Step& step) {
  const PlainNames names(plant_);
  reference::ScenarioStep it;
  it.when = static_cast<reference::ScenarioStep::When>(step.when);
  it.time = step.time;
  if (step.when == Step::When::wait && (it.wait = condition(step.wait)) == nullptr) return std::nullopt;
  if (!settings(step.set, it.set) || !settings(step.force, it.force) || !settings(step.expect, it.expect)) {
    return std::nullopt;
  }
  for (const auto& [device, state] : step.states) {
    const auto unit = names.unit(device, {});
    const auto position = unit ? names.state(*unit, state) : std::nullopt;
    if (!position) return std::nullopt;
    it.states.emplace_back(*unit, *position);
  }
  for (const auto& [at, name] : step.put) {
    const auto location = part_location(plant_.material, at);
    const auto kind = names.part_kind(name);
    if (!location || !kind) return std::nullopt;
    it.put.emplace_back(*location, *kind);
  }
  for (const std::string& from : step.take) {
    const auto location = part_location(plant_.material, from);
    if (!location) return std::nullopt;
    it.take.push_back(*location);
  }
  for (const std::string& name : step.release) {
    const auto symbol = names.symbol(name);
    if (!symbol) return std::nullopt;
    it.release.push_back(symbol->index);
  }
  if (!malfunctions(step.stop, it.stop) || !malfunctions(step.start, it.start)) return std::nullopt;
  it.starts_ordinary = std::any_of(it.start.begin(), it.start.end(),
                                   [&](std::uint32_t number) { return number >= plant_.malfunctions.size(); });
  if (!step.expect_condition.empty()) {
    it.expect_condition = condition(step.expect_condition);
    if (it.expect_condition == nullptr) return std::nullopt;
  }
  it.expects = !step.expect.empty() || !step.expect_condition.empty();
  return it;
}

}  // namespace symplant::property::files
