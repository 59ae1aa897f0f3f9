// Copies of devices.
#include "property/files/copies.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "property/files/joined_requirements.hpp"
#include "property/simpler.hpp"
#include "support/reference/rules.hpp"

namespace symplant::property::files {
namespace {

/// Replaces the path of a device where a name begins with it.
std::string renamed(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += 1) {
    const char next = at + from.size() < text.size() ? text[at + from.size()] : ' ';
    if (next != '.' && next != '_') continue;
    text.replace(at, from.size(), to);
    at += to.size() - 1;
  }
  return text;
}

class Copier {
 public:
  Copier(Dice& dice, PlantText& plant, std::string path) : dice_(dice), plant_(plant), path_(std::move(path)) {}

  void copy() {
    const std::string to = new_path();
    std::vector<Row> rows;
    for (const Row& row : plant_.rows) {
      if (!row.name.starts_with(path_ + "_")) continue;
      Row made = row;
      made.name = to + row.name.substr(path_.size());
      if (made.type != "BOOL") made.address.clear();
      if (!made.address.empty()) made.address = made.address.substr(0, 3) + std::to_string(next_++);
      rows.push_back(std::move(made));
    }
    plant_.rows.insert(plant_.rows.end(), rows.begin(), rows.end());
    auto& devices = plant_.description.devices;
    const auto of = std::find_if(devices.begin(), devices.end(), [&](const auto& it) { return it.path == path_; });
    if (of == devices.end()) return;
    description::DeviceDescription device = *of;
    device.path = to;
    for (description::GivenTransition& given : device.transitions) {
      given.when = renamed(given.when, path_, to);
      given.during = renamed(given.during, path_, to);
    }
    for (auto& [name, condition] : device.inputs) condition = renamed(condition, path_, to);
    devices.push_back(std::move(device));
  }

 private:
  std::string new_path() {
    for (;;) {
      std::string path = "L" + std::to_string(dice_.below(3)) + (dice_.percent(70) ? "_P_" : "_Q_") + "D" +
                         std::to_string(dice_.below(dice_.percent(80) ? 10 : 100));
      const auto taken = [&](const Row& row) { return reference::upper(row.name).starts_with(path + "_"); };
      if (std::none_of(plant_.rows.begin(), plant_.rows.end(), taken)) return path;
    }
  }

  Dice& dice_;
  PlantText& plant_;
  const std::string path_;
  std::size_t next_ = 40'000;  ///< a free address
};

/// Inputs have no effect without a behavior.
void add_inputs(Dice& dice, PlantText& plant, const std::string& path) {
  for (description::DeviceDescription& device : plant.description.devices) {
    if (device.path != path || !device.behaviour.empty()) continue;
    std::vector<std::pair<std::string, std::string>> inputs{{"in_move", path + ".moving"}};
    for (const description::GivenTransition& given : device.transitions) {
      if (!given.when.empty() && dice.percent(50))
        inputs.emplace_back("in_" + std::to_string(inputs.size()), given.when);
    }
    device.inputs = std::move(inputs);
  }
}

bool is_sound(const PlantText& plant) {
  const model::Derived derived = build(plant);
  return derived.evidence.faults.empty() && derived.evidence.driven_twice.empty();
}

bool follows(const PlantText& plant, const std::string& path) {
  const auto& follow = plant.description.follow;
  return std::any_of(follow.begin(), follow.end(), [&](const auto& given) { return given.symbol.starts_with(path); });
}

}  // namespace

void add_copies(Dice dice, PlantText& plant) {
  if (plant.rows.empty() || dice.percent(50)) return;
  PlantText copy = plant;
  const std::string path = dice.pick(unit_paths(copy));
  if (follows(copy, path)) return;
  if (dice.percent(40)) add_inputs(dice, copy, path);
  Copier copier(dice, copy, path);
  for (std::size_t i = 1 + dice.below(3); i > 0; --i) copier.copy();
  if (dice.percent(70)) add_joinable_requirements(dice, copy, path);
  if (is_sound(copy)) plant = std::move(copy);
}

}  // namespace symplant::property::files
