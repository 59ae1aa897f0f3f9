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

/// The condition with names of another line.
std::string on_line(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from + "_", at)) != text.npos; ++at) text.replace(at, from.size(), to);
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
    const KnownNames known = known_names(build(plant_).plant);
    std::erase_if(device.transitions, [&](description::GivenTransition& given) {
      return !copied(given.when, to, known) || !copied(given.during, to, known);
    });
    for (description::GivenDisables& given : device.disables) {
      std::erase_if(given.devices, [&](std::string& other) {
        const std::string there = on_line(other, path_.substr(0, 2), to.substr(0, 2));
        if (there == to || (there != other && dice_.percent(80) && !knows_device(known, there))) return true;
        if (knows_device(known, there)) other = there;
        return false;
      });
    }
    std::erase_if(device.disables, [](const auto& given) { return given.devices.empty(); });
    for (auto& [name, condition] : device.inputs) condition = renamed(condition, path_, to);
    devices.push_back(std::move(device));
  }

 private:
  /// Makes a condition one of the copy; false if its line lacks what the condition names, and the copy the transition.
  bool copied(std::string& condition, const std::string& to, const KnownNames& known) {
    condition = renamed(condition, path_, to);
    const std::string other = on_line(condition, path_.substr(0, 2), to.substr(0, 2));
    if (other == condition || dice_.percent(20)) return true;
    if (!knows(known, other)) return false;
    condition = other;
    return true;
  }

  std::string new_path() {
    for (int tries = 0;; ++tries) {
      std::string path = "L" + std::to_string(dice_.below(3)) + (dice_.percent(70) ? "_P_" : "_Q_") + "D" +
                         std::to_string(dice_.below(dice_.percent(80) ? 10 : 100));
      if (tries < 3 && dice_.percent(70)) path = "L" + std::to_string(dice_.below(3)) + path_.substr(2);
      const auto taken = [&](const Row& row) {
        return reference::upper(row.name).starts_with(reference::upper(path) + "_");
      };
      if (std::none_of(plant_.rows.begin(), plant_.rows.end(), taken)) return path;
    }
  }

  Dice& dice_;
  PlantText& plant_;
  const std::string path_;
  std::size_t next_ = 42'000;  ///< a free address
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

/// A transition that depends on another device of the line, which copies on other lines may lack.
void depend_on_the_line(Dice& dice, PlantText& plant, const std::string& path) {
  const model::PlantModel model = build(plant).plant;
  std::vector<std::string> others;
  const model::Unit* own = nullptr;
  for (const model::Unit& unit : model.units) {
    if (unit.path == path) {
      own = &unit;
    } else if (unit.path.starts_with(path.substr(0, 2))) {
      others.push_back(std::string(unit.path) + "." + dice.pick(unit.states).name);
    }
  }
  if (own == nullptr || others.empty() || own->rest_added) return;
  description::GivenTransition given;
  given.from = own->states.front().name;
  given.to = own->states.back().name;
  given.automatic = true;
  given.after = description::Duration::fixed(20 * tables::kMillisecond);
  (dice.percent(50) ? given.when : given.during) = dice.pick(others);
  for (description::DeviceDescription& device : plant.description.devices) {
    if (device.path == path) device.transitions.push_back(given);
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
  if (plant.rows.empty() || dice.percent(35)) return;
  PlantText copy = plant;
  const std::vector<std::string> paths = unit_paths(copy);
  if (paths.empty()) return;
  const std::string path = dice.pick(paths);
  if (follows(copy, path)) return;
  if (dice.percent(60)) depend_on_the_line(dice, copy, path);
  if (dice.percent(40)) add_inputs(dice, copy, path);
  Copier copier(dice, copy, path);
  for (std::size_t i = 1 + dice.below(4); i > 0; --i) copier.copy();
  if (dice.percent(70)) add_joinable_requirements(dice, copy, path);
  if (is_sound(copy)) plant = std::move(copy);
}

}  // namespace symplant::property::files
