// Devices of one kind: those whose names differ in digits alone.
#include "check/device_classes.hpp"

#include <string>

#include "base/ascii.hpp"

namespace symplant::check {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::uint32_t kLeastSiblings = 3;

}  // namespace

std::string class_name(std::string_view device) {
  std::string name;
  name.reserve(device.size());
  for (std::size_t i = 0; i < device.size(); ++i) {
    if (!is_digit(device[i])) {
      name += base::upper(device[i]);
    } else if (i == 0 || !is_digit(device[i - 1])) {
      name += '#';
    }
  }
  return name;
}

std::size_t DeviceClasses::HashPart::operator()(const Part& part) const {
  const std::size_t side = 2 * std::size_t{part.of} + (part.direction == core::Direction::operation ? 1U : 0U);
  return base::HashIgnoringCase{}(part.task) ^ (side * 0x9E37'79B9'7F4A'7C15U);
}

bool DeviceClasses::SamePart::operator()(const Part& a, const Part& b) const {
  return a.of == b.of && a.direction == b.direction && base::equal_ignoring_case(a.task, b.task);
}

DeviceClasses::DeviceClasses(const model::PlantModel& plant) {
  std::unordered_map<std::string, std::uint32_t> by_name;
  class_of_.reserve(plant.units.size());
  for (std::uint32_t unit = 0; unit < plant.units.size(); ++unit) {
    const model::Unit& of = plant.units[unit];
    const auto [found, added] = by_name.try_emplace(class_name(of.device), static_cast<std::uint32_t>(classes_.size()));
    if (added) {
      classes_.emplace_back();
      parts_.emplace_back();
    }
    classes_[found->second].units.push_back(unit);
    class_of_.push_back(found->second);
    for (const auto* side : {&of.operations, &of.events}) {
      for (const std::uint32_t symbol : *side) add_part(found->second, plant.symbols[symbol]);
    }
  }
}

void DeviceClasses::add_part(std::uint32_t of, const model::Symbol& symbol) {
  const Part part{of, symbol.direction, symbol.reading.task};
  const auto [found, added] = counts_.try_emplace(part, 0U);
  ++found->second;
  if (added) parts_[of].push_back(part);
}

std::uint32_t DeviceClasses::count(std::uint32_t of, core::Direction direction, std::string_view task) const {
  const auto found = counts_.find({of, direction, task});
  return found == counts_.end() ? 0U : found->second;
}

Expected DeviceClasses::expects(std::uint32_t unit, core::Direction direction, std::string_view task, bool has) const {
  const std::uint32_t of = class_of_[unit];
  const auto siblings = static_cast<std::uint32_t>(classes_[of].units.size() - 1);
  if (siblings < kLeastSiblings) return Expected::unclear;
  const std::uint32_t with = count(of, direction, task) - (has ? 1U : 0U);
  if (4 * std::uint64_t{with} >= 3 * std::uint64_t{siblings}) return Expected::yes;
  return 4 * std::uint64_t{with} <= siblings ? Expected::no : Expected::unclear;
}

}  // namespace symplant::check
