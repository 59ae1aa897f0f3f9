// Names of a matched device in braces: a second implementation, as simple as possible.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "property/dice.hpp"

namespace symplant::property::files {

/// By the name in braces: its replacement.
using BraceNames = std::map<std::string, std::string>;

/// What can be in braces for a device LINE_PROC_DEV that a pattern matches.
BraceNames brace_names(const std::string& path, const std::string& pattern);

bool has_braces(const std::string& text);
/// All braces replaced. An unknown name stays.
std::string expanded(const std::string& text, const BraceNames& names);

/// Whether every name with braces in a condition becomes a name, for this device.
bool stays_a_condition(const std::string& condition, const BraceNames& names);

/// The text with braces for parts of its names; expanded() restores it. Perhaps the text itself.
std::string with_braces(Dice& dice, const std::string& text, const BraceNames& names);

/// Calls `edit` for each text of a key of `devices` that may have braces; a text twice in the value becomes the same.
/// Names of devices in `disables` are no conditions.
void edit_texts(nlohmann::json& value, const std::string& key,
                const std::function<std::string(const std::string& text)>& edit);

/// What a plant has, in upper case.
struct KnownNames {
  std::set<std::string> devices;
  std::set<std::string> in_conditions;  ///< symbols, DEVICE.STATE and DEVICE.moving, parts
};
KnownNames known_names(const model::PlantModel& plant);
bool knows_device(const KnownNames& known, const std::string& path);
/// Whether all names of a condition are known.
bool knows(const KnownNames& known, const std::string& condition);

}  // namespace symplant::property::files
