// Finds the entries of patterns that a unit lacks, because they make names that the plant lacks.
#include "model/made_transitions.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

#include "model/plant_names.hpp"

namespace symplant::model {
namespace {

using description::DeviceDescription;
using description::DeviceKey;
using description::GivenTransition;

bool has_braces(const GivenTransition& given) { return text::has_braces(given.when) || text::has_braces(given.during); }

bool has_braces(const DeviceDescription& device) {
  return std::any_of(device.transitions.begin(), device.transitions.end(),
                     [](const GivenTransition& given) { return has_braces(given); });
}

/// What a condition names that the plant lacks, as a message; empty if it lacks nothing, or if the text has another
/// fault, which is reported where the condition is read.
std::string missing_in(const std::string& text, const MatchedNames& matched, const PlantNames& names) {
  if (!text::has_braces(text)) return {};
  const text::Replaced made = matched.replace(text);
  if (!made.unknown.empty()) return {};
  const auto parsed = condition::parse(made.text);
  const auto* expression = std::get_if<condition::Expression>(&parsed);
  if (expression == nullptr) return {};
  const auto resolved = condition::resolve(*expression, names);
  const auto* fault = std::get_if<condition::Fault>(&resolved);
  return fault == nullptr ? std::string() : fault->message;
}

void leave_out(PlantModel& plant, Unit& unit, const PlantNames& names, MadeNames& made) {
  const DeviceDescription& entry = unit.described->entry_of(DeviceKey::transitions);
  const auto& given = unit.described->transitions;
  const MatchedNames matched = MatchedNames::of(plant, unit, entry.path);
  const description::Pointer pointer = description::key_pointer(*unit.described, DeviceKey::transitions);
  for (std::uint32_t i = 0; i < given.size(); ++i) {
    bool lacking = false;
    const auto look_at = [&](const std::string& text, const description::Pointer& here) {
      if (lacking || !text::has_braces(text)) return;
      made.takes(here);
      std::string message = missing_in(text, matched, names);
      if (message.empty()) return;
      made.lacks(here, unit.path, std::move(message), text);
      lacking = true;
    };
    look_at(given[i].when, pointer / i / "when");
    look_at(given[i].during, pointer / i / "while");
    if (lacking) unit.left_out.push_back(i);
  }
}

/// Whether the plant has what a text of the entry at `at` names for a unit: a device for `disables`, else a condition.
bool has_made(const PlantModel& plant, const PlantNames& names, const Unit& unit, const description::Pointer& at,
              const std::string& text) {
  const MatchedNames matched = MatchedNames::of(plant, unit, at.pattern_text());
  if (at.key() != DeviceKey::disables) return missing_in(text, matched, names).empty();
  const std::string device = matched.replace(text).text;
  return names.unit(device, {}).has_value() || !names.facets(device).empty();
}

}  // namespace

bool makes_names(const description::Description& description) {
  return std::any_of(description.devices.begin(), description.devices.end(),
                     [](const DeviceDescription& device) { return has_braces(device); });
}

void leave_out_unknown(PlantModel& plant, MadeNames& made, const description::Faults& faults) {
  const PlantNames names(plant, faults);
  for (Unit& unit : plant.units) {
    if (unit.described == nullptr || !has_braces(*unit.described)) continue;
    if (unit.described->entry_of(DeviceKey::transitions).is_pattern()) leave_out(plant, unit, names, made);
  }
}

void report_made_names(const PlantModel& plant, const MadeNames& made, description::Faults& faults) {
  std::optional<PlantNames> names;
  made.report(faults, [&](const description::Pointer& at, const std::string& text) {
    if (!names) names.emplace(plant, faults);
    return std::any_of(plant.units.begin(), plant.units.end(), [&](const Unit& unit) {
      return at.pattern()->matches(unit.path, unit.device_path()) && has_made(plant, *names, unit, at, text);
    });
  });
}

}  // namespace symplant::model
