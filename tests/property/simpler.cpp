// Small single edits of a plant.
#include "property/simpler.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace symplant::property {
namespace {

using description::Duration;

constexpr tables::Time kPlainTime = 10 * tables::kMillisecond;

std::string upper(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// Whether a condition names the unit or a symbol of it.
bool names(const std::string& condition, const std::string& path) {
  const std::string text = upper(condition);
  const std::string wanted = upper(path);
  return text.find(wanted + ".") != text.npos || text.find(wanted + "_") != text.npos;
}

/// The atoms of a condition, each as a condition.
std::vector<std::string> atoms_of(const std::string& condition) {
  std::vector<std::string> atoms;
  std::string atom;
  const auto end = [&] {
    while (!atom.empty() && atom.back() == ' ') atom.pop_back();
    if (!atom.empty()) atoms.push_back(std::exchange(atom, {}));
  };
  for (std::size_t i = 0; i < condition.size();) {
    const std::string_view rest = std::string_view(condition).substr(i);
    const std::size_t word = rest.starts_with("and ")   ? 4
                             : rest.starts_with("or ")  ? 3
                             : rest.starts_with("not ") ? 4
                                                        : 0;
    const bool begins = i == 0 || condition[i - 1] == ' ' || condition[i - 1] == '(';
    if (word != 0 && begins) {
      end();
      i += word;
    } else if (condition[i] == '(' || condition[i] == ')') {
      end();
      ++i;
    } else {
      if (condition[i] != ' ' || !atom.empty()) atom += condition[i];
      ++i;
    }
  }
  end();
  return atoms;
}

/// Calls the visitor for every item of its kind; the visitor counts and edits.
class Edits {
 public:
  explicit Edits(std::optional<std::size_t> wanted) : wanted_(wanted) {}

  void plant(PlantText& plant) {
    for (description::DeviceDescription& device : plant.description.devices) {
      for (description::GivenTransition& given : device.transitions) transition(given);
      for (description::GivenOutputs& given : device.outputs) {
        pairs(given.enter);
        pairs(given.leave);
      }
      for (description::GivenDisables& given : device.disables) pairs(given.devices);
      for (auto& [name, text] : device.inputs) condition(text, false);
    }
    for (description::GivenFollow& given : plant.description.follow) condition(given.condition, false);
    for (description::GivenRequirement& given : plant.description.requirements) {
      condition(given.never, false);
      condition(given.after, false);
      condition(given.expect, false);
      if (given.earliest != 0) edit([&] { given.earliest = 0; });
      if (given.within != given.earliest) edit([&] { given.within = given.earliest; });
    }
    each_condition(plant.description.material, [this](std::string& text, bool none) { condition(text, none); });
    each_edit(plant.description.material, [this](const std::function<void()>& make) { edit(make); });
    each_condition(plant.description.malfunctions, [this](std::string& text, bool none) { condition(text, none); });
    each_edit(plant.description.malfunctions, [this](const std::function<void()>& make) { edit(make); });
    each_condition(plant.description, [this](std::string& text, bool none) { condition(text, none); });
    each_edit(plant.description, [this](const std::function<void()>& make) { edit(make); });
    if (plant.description.defaults.actuation != tables::Actuation::latched) {
      edit([&] { plant.description.defaults.actuation = tables::Actuation::latched; });
    }
  }

  std::size_t count = 0;

 private:
  template <class Edit>
  void edit(Edit&& make) {
    if (wanted_ == count++) make();
  }

  void transition(description::GivenTransition& given) {
    condition(given.when, true);
    condition(given.during, true);
    if (given.numbers.weight != 0) edit([&] { given.numbers.weight = 0; });
    if (given.numbers.weight > 1) edit([&] { given.numbers.weight = 1; });
    duration(given.after);
    duration(given.takes);
    if (given.once) edit([&] { given.once = false; });
  }

  void condition(std::string& text, bool may_be_none) {
    if (text.empty()) return;
    if (may_be_none) edit([&] { text.clear(); });
    const auto atoms = atoms_of(text);
    for (const std::string& atom : atoms) {
      if (atom != text && "not " + atom != text) edit([&] { text = atom; });
      if (atoms.size() > 1) edit([&] { text = "not " + atom; });
    }
  }

  void duration(std::optional<Duration>& given) {
    if (!given) return;
    edit([&] { given.reset(); });
    if (given && given->kind != Duration::Kind::fixed) edit([&] { given = Duration::fixed(kPlainTime); });
  }

  template <class List>
  void pairs(List& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      edit([&] { list.erase(list.begin() + static_cast<std::ptrdiff_t>(i)); });
    }
  }

  std::optional<std::size_t> wanted_;
};

std::size_t duration_size(const std::optional<Duration>& given) {
  return !given ? 0 : given->kind == Duration::Kind::fixed ? 1 : 2;
}

}  // namespace

std::size_t plant_size(const PlantText& plant) {
  std::size_t size = 10 * plant.rows.size();
  for (const Row& row : plant.rows) size += row.initial.size();
  for (const description::DeviceDescription& device : plant.description.devices) {
    size += 10 + device.states.size() + device.inputs.size() + (device.initial ? 1 : 0) + (device.rest ? 1 : 0) +
            (device.actuation ? 1 : 0) + (device.overrun ? 1 : 0) + (device.sequence ? 1 : 0) + (device.only ? 1 : 0) +
            device.type.size() + device.behaviour.size();
    for (const description::GivenTransition& given : device.transitions) {
      size += 5 + given.when.size() + given.during.size() + (given.numbers.weight > 1 ? 2 : given.numbers.weight) +
              duration_size(given.after) + duration_size(given.takes) + (given.once ? 1 : 0);
    }
    for (const description::GivenOutputs& given : device.outputs) size += 1 + given.enter.size() + given.leave.size();
    for (const description::GivenDisables& given : device.disables) size += 1 + given.devices.size();
    for (const auto& [name, text] : device.inputs) size += text.size();
  }
  size += plant.description.inverted.size() + material_size(plant.description.material) +
          malfunctions_size(plant.description.malfunctions) + values_size(plant.description);
  for (const description::GivenFollow& given : plant.description.follow) size += 5 + given.condition.size();
  for (const description::GivenRequirement& given : plant.description.requirements) {
    size += 10 + given.never.size() + given.after.size() + given.expect.size() + (given.within == 0 ? 0 : 1) +
            (given.earliest == 0 ? 0 : 1);
  }
  return size;
}

std::vector<std::string> unit_paths(const PlantText& plant) {
  std::vector<std::string> paths;
  for (const Row& row : plant.rows) {
    std::size_t end = row.name.find("_I_");
    if (end == row.name.npos) end = row.name.find("_O_");
    if (end == row.name.npos) continue;
    std::string path = row.name.substr(0, end);
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(std::move(path));
  }
  return paths;
}

void remove_unit(PlantText& plant, const std::string& path) {
  const auto of_unit = [&](const std::string& name) { return upper(name).starts_with(upper(path) + "_"); };
  std::erase_if(plant.rows, [&](const Row& row) { return of_unit(row.name); });
  auto& description = plant.description;
  std::erase_if(description.devices, [&](const auto& device) { return upper(device.path) == upper(path); });
  for (description::DeviceDescription& device : description.devices) {
    std::erase_if(device.transitions,
                  [&](const auto& given) { return names(given.when, path) || names(given.during, path); });
    for (description::GivenDisables& given : device.disables) std::erase(given.devices, path);
    std::erase_if(device.disables, [](const auto& given) { return given.devices.empty(); });
  }
  std::erase_if(description.inverted, of_unit);
  std::erase_if(description.follow,
                [&](const auto& given) { return of_unit(given.symbol) || names(given.condition, path); });
  std::erase_if(description.requirements, [&](const auto& given) {
    return names(given.never, path) || names(given.after, path) || names(given.expect, path);
  });
  remove_from_malfunctions(plant, of_unit, [&](const std::string& condition) { return names(condition, path); });
}

bool give_own_address(PlantText& plant, std::size_t row) {
  std::string& address = plant.rows[row].address;
  const auto shares = [&](const Row& other) { return &other != &plant.rows[row] && other.address == address; };
  if (address.empty() || std::none_of(plant.rows.begin(), plant.rows.end(), shares)) return false;
  address = address.substr(0, 3) + std::to_string(20'000 + row);
  return true;
}

std::size_t count_simpler(const PlantText& plant) {
  PlantText copy = plant;
  Edits edits(std::nullopt);
  edits.plant(copy);
  return edits.count;
}

void make_simpler(PlantText& plant, std::size_t number) { Edits(number).plant(plant); }

}  // namespace symplant::property
