// Devices of one kind: those whose names differ only in digits.
#include "check/spelling/device_classes.hpp"

#include <algorithm>
#include <string>

#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::uint32_t kLeastSiblings = 3;

bool by_device(const DeviceClasses::Number& a, const DeviceClasses::Number& b) { return a.device < b.device; }

}  // namespace

std::string class_name(std::string_view device) {
  std::string name;
  name.reserve(device.size());
  for (std::size_t i = 0; i < device.size(); ++i) {
    if (!text::is_digit(device[i])) {
      name += text::upper(device[i]);
    } else if (i == 0 || !text::is_digit(device[i - 1])) {
      name += '#';
    }
  }
  return name;
}

std::size_t DeviceClasses::HashPart::operator()(const Part& part) const {
  const std::size_t side = 2 * std::size_t{part.of} + (part.direction == tables::Direction::operation ? 1U : 0U);
  return text::HashIgnoringCase{}(part.task) ^ (side * 0x9E37'79B9'7F4A'7C15U);
}

bool DeviceClasses::SamePart::operator()(const Part& a, const Part& b) const {
  return a.of == b.of && a.direction == b.direction && text::equal_ignoring_case(a.task, b.task);
}

DeviceClasses::DeviceClasses(const model::PlantModel& plant) : device_of_(plant.symbols.size(), model::kNone) {
  class_of_.reserve(plant.units.size());
  first_symbol_.reserve(plant.units.size());
  for (std::uint32_t device = 0; device < plant.units.size(); ++device) {
    const model::Unit& unit = plant.units[device];
    std::uint32_t first = model::kNone;
    for (const auto* side : {&unit.operations, &unit.events}) {
      if (!side->empty()) first = std::min(first, side->front());
    }
    add_device(unit.device, first);
    for (const auto* side : {&unit.operations, &unit.events}) {
      for (const std::uint32_t symbol : *side) add_part(device, symbol, plant);
    }
  }
  add_numeric(plant);
}

void DeviceClasses::add_device(std::string_view name, std::uint32_t first_symbol) {
  const auto [found, added] = class_by_name_.try_emplace(class_name(name), static_cast<std::uint32_t>(classes_.size()));
  if (added) classes_.push_back({name, {}, {}});
  classes_[found->second].devices.push_back(static_cast<std::uint32_t>(class_of_.size()));
  class_of_.push_back(found->second);
  first_symbol_.push_back(first_symbol);
}

void DeviceClasses::add_part(std::uint32_t device, std::uint32_t symbol, const model::PlantModel& plant) {
  const model::Symbol& of = plant.symbols[symbol];
  device_of_[symbol] = device;
  const Part part{class_of_[device], of.direction, of.reading.task()};
  const auto [found, added] = part_.try_emplace(part, static_cast<std::uint32_t>(parts_.size()));
  if (added) {
    classes_[part.of].parts.push_back(found->second);
    parts_.push_back(part);
    counts_.push_back(0);
  }
  ++counts_[found->second];
}

void DeviceClasses::add_numeric(const model::PlantModel& plant) {
  text::ByName<std::uint32_t> by_path;
  for (std::uint32_t symbol = 0; symbol < plant.symbols.size(); ++symbol) {
    const model::Symbol& of = plant.symbols[symbol];
    if (of.unmodelled != model::Unmodelled::numeric || of.reading.fault != name::NameFault::none) continue;
    if (by_path.empty()) {
      by_path.reserve(plant.units.size());
      for (std::uint32_t unit = 0; unit < plant.units.size(); ++unit) by_path.emplace(plant.units[unit].path, unit);
    }
    const auto [found, added] =
        by_path.try_emplace(of.reading.device_path(), static_cast<std::uint32_t>(class_of_.size()));
    if (added) add_device(of.reading.device(), symbol);
    std::uint32_t& first = first_symbol_[found->second];
    first = std::min(first, symbol);
    add_part(found->second, symbol, plant);
    numbers_.push_back({found->second, symbol});
  }
  std::stable_sort(numbers_.begin(), numbers_.end(), by_device);
}

std::span<const DeviceClasses::Number> DeviceClasses::numbers_of(std::uint32_t device) const {
  const auto [begin, end] = std::equal_range(numbers_.begin(), numbers_.end(), Number{device, 0}, by_device);
  return {begin, end};
}

std::uint32_t DeviceClasses::class_called(const std::string& name) const {
  const auto found = class_by_name_.find(name);
  return found == class_by_name_.end() ? model::kNone : found->second;
}

std::uint32_t DeviceClasses::find(std::uint32_t of, tables::Direction direction, std::string_view task) const {
  const auto found = part_.find({of, direction, task});
  return found == part_.end() ? model::kNone : found->second;
}

Expected DeviceClasses::expects(std::uint32_t device, tables::Direction direction, std::string_view task,
                                bool has) const {
  const std::uint32_t of = class_of_[device];
  const auto siblings = static_cast<std::uint32_t>(classes_[of].devices.size() - 1);
  if (siblings < kLeastSiblings) return Expected::unclear;
  const std::uint32_t part = find(of, direction, task);
  const std::uint32_t with = part == model::kNone ? 0 : counts_[part] - (has ? 1U : 0U);
  if (4 * std::uint64_t{with} >= 3 * std::uint64_t{siblings}) return Expected::yes;
  return 4 * std::uint64_t{with} <= siblings ? Expected::no : Expected::unclear;
}

}  // namespace symplant::check
