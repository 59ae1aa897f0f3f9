// plant.json of a random plant.
#include "property/files/plant_json.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "property/files/copies.hpp"
#include "property/files/joined_material.hpp"
#include "property/files/joined_requirements.hpp"
#include "property/files/json_printer.hpp"
#include "property/files/malfunctions_json.hpp"
#include "property/files/material_json.hpp"
#include "property/files/spread.hpp"
#include "property/files/values_json.hpp"
#include "property/words.hpp"

namespace symplant::property::files {
namespace {

using nlohmann::json;

void clip(tables::Time& time) { time = std::min(time, tables::kNever - 1); }

void clip(std::optional<description::Duration>& duration) {
  if (!duration) return;
  clip(duration->a);
  clip(duration->b);
}

void clip(std::vector<std::pair<std::string, bool>>& events) {
  const std::map<std::string, bool> by_name(events.begin(), events.end());
  events.assign(by_name.begin(), by_name.end());
}

void add_behaviour(Dice& dice, const PlantText& plant, description::DeviceDescription& device) {
  // A separate name for each device: devices with the same behavior must have the same structure.
  const auto& devices = plant.description.devices;
  const auto same = [&](const description::DeviceDescription& other) { return other.path == device.path; };
  device.behaviour = "MyOwnCode" + std::to_string(std::find_if(devices.begin(), devices.end(), same) - devices.begin());
  // Conditions elsewhere in the description always name existing things.
  for (const description::GivenRequirement& requirement : plant.description.requirements) {
    const std::string& text = requirement.never.empty() ? requirement.expect : requirement.never;
    if (dice.percent(50)) device.inputs.emplace_back("in_" + requirement.name, text);
  }
}

/// Whether the symbol belongs to a sensor, and so to no device.
bool is_part_sensor(const description::GivenMaterial& material, const std::string& symbol) {
  const auto has_it = [&](const auto& location) {
    return std::any_of(location.sensors.begin(), location.sensors.end(),
                       [&](const description::GivenSensor& sensor) { return sensor.symbol == symbol; });
  };
  return std::any_of(material.tracks.begin(), material.tracks.end(), has_it) ||
         std::any_of(material.places.begin(), material.places.end(), has_it);
}

/// Whether the symbol is a signal or `plain`, and so of no device.
bool is_of_values(const description::Description& description, const std::string& symbol) {
  const auto& signals = description.signals;
  return std::find(description.plain.begin(), description.plain.end(), symbol) != description.plain.end() ||
         std::any_of(signals.begin(), signals.end(),
                     [&](const description::GivenSignal& signal) { return signal.symbol == symbol; });
}

std::set<std::string> tasks_of(const PlantText& plant, const std::string& path,
                               const description::DeviceDescription* said) {
  std::set<std::string> tasks;
  const auto upper = [](std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  };
  for (const Row& row : plant.rows) {
    if (!upper(row.name).starts_with(upper(path) + "_") || row.name.size() < path.size() + 3) continue;
    if (is_part_sensor(plant.description.material, row.name) || is_of_values(plant.description, row.name)) continue;
    tasks.insert(upper(row.name.substr(path.size() + 3)));
  }
  if (said != nullptr) {
    for (const std::string& state : said->states) tasks.insert(upper(state));
  }
  return tasks;
}

/// All devices, and what the description defines for each.
std::vector<Wish> wishes_of(const PlantText& plant, const model::PlantModel& model, const KnownNames& known,
                            const Style& style, Counts& counts) {
  std::vector<std::string> paths;
  for (const model::Unit& unit : model.units) paths.emplace_back(unit.path);
  std::vector<Wish> wishes;
  for (const model::Unit& unit : model.units) {
    Wish wish{std::string(unit.path), tasks_of(plant, std::string(unit.path), unit.described), {}, &known};
    if (unit.described != nullptr) {
      Sayer sayer(style, unit.path, counts);
      wish.keys = sayer.keys(*unit.described, paths);
    }
    wishes.push_back(std::move(wish));
  }
  return wishes;
}

json list_of(Sayer& sayer, bool decorated, const char* name, const std::string& controller) {
  if (controller.empty() && (!decorated || sayer.dice.percent(60))) return name;
  json list = {{"file", name}};
  if (!controller.empty()) list["controller"] = controller;
  if (!decorated) return list;
  if (sayer.dice.percent(40)) list["format"] = "gx-iec";
  if (sayer.dice.percent(40)) list["encoding"] = "utf-8";
  if (sayer.dice.percent(40)) list["xy"] = sayer.dice.percent(50) ? "hex" : "octal";
  return list;
}

json defaults_of(const description::Defaults& defaults, Sayer& sayer) {
  json said = json::object();
  const description::Defaults without;
  if (defaults.overrun != without.overrun) said["overrun"] = sayer.overrun(defaults.overrun);
  if (defaults.sequence != without.sequence) said["sequence"] = sayer.sequence(defaults.sequence);
  if (defaults.travel != without.travel) said["travel"] = sayer.time(defaults.travel);
  if (defaults.dwell != without.dwell) said["dwell"] = sayer.time(defaults.dwell);
  if (defaults.step != without.step) said["step"] = sayer.time(defaults.step);
  if (defaults.actuation != without.actuation || sayer.dice.percent(10)) {
    said["actuation"] = word_of(defaults.actuation);
  }
  return said;
}

}  // namespace

void make_sayable(PlantText& plant, std::uint64_t seed) {
  Dice dice(seed ^ 0xF11E5);
  add_copies(Dice(seed ^ 0xCE115), plant);
  add_joinable_material(Dice(seed ^ 0xCE117), plant);
  description::Description& description = plant.description;
  clip(description.defaults.travel);
  clip(description.defaults.dwell);
  for (description::GivenRequirement& requirement : description.requirements) {
    clip(requirement.within);
    clip(requirement.earliest);
  }
  for (description::GivenSource& source : description.material.sources) {
    clip(source.every);
    clip(source.first);
  }
  if (dice.percent(15)) {
    plant.second_list = dice.below(plant.rows.size());
    if (dice.percent(50)) plant.second_controller = "PLC2";
  }
  make_malfunctions_sayable(plant);
  for (description::DeviceDescription& device : description.devices) {
    for (description::GivenTransition& transition : device.transitions) {
      clip(transition.after);
      clip(transition.takes);
    }
    for (description::GivenOutputs& outputs : device.outputs) {
      clip(outputs.enter);
      clip(outputs.leave);
    }
    if (dice.percent(4)) add_behaviour(dice, plant, device);
    std::sort(device.inputs.begin(), device.inputs.end());
  }
}

std::string plant_json(const PlantText& plant, const Style& style, Counts& counts) {
  Sayer sayer(style, "plant", counts);
  Dice& dice = sayer.dice;
  json said = {{"symplant", 1}, {"name", plant.name}, {"symbols", json::array()}};
  said["symbols"].push_back(list_of(sayer, style.decorated, kListNames[0], ""));
  if (plant.two_lists()) {
    ++counts[Seen::second_lists];
    said["symbols"].push_back(list_of(sayer, style.decorated, kListNames[1], plant.second_controller));
  }
  const json defaults = defaults_of(plant.description.defaults, sayer);
  if (!defaults.empty()) said["defaults"] = defaults;
  json devices = json::object();
  const model::PlantModel model = build(plant).plant;
  const KnownNames known = known_names(model);
  const std::vector<Wish> wishes = wishes_of(plant, model, known, style, counts);
  for (const Entry& entry : spread(wishes, style, counts)) devices[entry.name] = entry.keys;
  if (!devices.empty() || dice.percent(10)) said["devices"] = devices;
  for (const std::string& symbol : plant.description.inverted) {
    said["inverted"].push_back(sayer.name(symbol));
    ++counts[Seen::inverted];
  }
  for (const description::GivenFollow& given : plant.description.follow) {
    json condition = sayer.condition(given.condition);
    if (!given.off.empty()) condition = {{"on", condition}, {"off", sayer.condition(given.off)}};
    said["follow"][sayer.name(given.symbol)] = condition;
    ++counts[Seen::follows];
    counts[Seen::switches] += given.off.empty() ? 0 : 1;
  }
  for (const description::GivenRequirement& requirement : joined_requirements(plant, style, known, counts)) {
    said["requirements"].push_back(sayer.requirement(requirement));
  }
  add_values(said, plant.description, sayer, counts);
  if (!plant.description.material.empty()) {
    said["material"] = material_json(joined_material(plant, style, counts), sayer, counts);
  }
  if (!plant.description.malfunctions.empty()) {
    said["malfunctions"] = malfunctions_json(plant.description, model, sayer, counts);
  }
  if (style.decorated) {
    if (dice.percent(10)) said["$schema"] = "plant.schema.json";
    if (dice.percent(10)) said["links"] = {{{"url", "loop:"}}};
    if (dice.percent(10)) {
      said["check"] = {{"ignore", {{{"rule", "event-not-driven"}, {"symbols", "*SPARE*"}, {"why", "not wired yet"}}}},
                       {"severity", {{"no-address", "note"}}}};
    }
  }
  return print_json(said, style.decorated, Dice(style.seed), counts[Seen::comments]);
}

}  // namespace symplant::property::files
