// Classes of devices by name, and those in them whose symbols differ.
#include "check/spelling/odd_devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "check/spelling/device_classes.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::size_t kLeastOthers = 3;
constexpr std::size_t kMeantShare = 8;  ///< what more than one in so many lack is meant to be lacking

/// A symbol that nearly all devices of a class have.
struct Common {
  tables::Direction direction;
  std::string_view task;
  std::uint32_t having;
  const model::Symbol* symbol;  ///< of the first that has it
};

class OddSearch {
 public:
  explicit OddSearch(const Subject& subject) : plant_(subject.plant), classes_(subject.classes) {}

  std::vector<OddDevice> find() {
    for (const DeviceClasses::Class& kind : classes_.classes()) {
      if (kind.devices.size() <= kLeastOthers || !collect_common(kind)) continue;
      for (const std::uint32_t device : kind.devices) {
        look_at(device, kind.devices.size());
      }
    }
    std::sort(odd_.begin(), odd_.end(), [](const OddDevice& a, const OddDevice& b) { return a.device < b.device; });
    return std::move(odd_);
  }

 private:
  /// Whether a device lacks any of what is common.
  bool collect_common(const DeviceClasses::Class& kind) {
    const std::vector<std::uint32_t>& devices = kind.devices;
    common_.clear();
    bool lacking = false;
    for (const std::uint32_t location : kind.parts) {
      const DeviceClasses::Part& part = classes_.parts()[location];
      const std::uint32_t having = classes_.count(location);
      if (having < kLeastOthers || 4 * std::size_t{having} < 3 * (devices.size() - 1)) continue;
      const std::size_t lack = devices.size() - having;
      if (lack > 1 && lack * kMeantShare > devices.size()) continue;
      const model::Symbol* symbol = nullptr;
      for (std::size_t i = 0; i < devices.size() && symbol == nullptr; ++i) {
        symbol = find_symbol(devices[i], part.direction, part.task);
      }
      if (symbol == nullptr) continue;
      common_.push_back({part.direction, part.task, having, symbol});
      lacking = lacking || lack != 0;
    }
    return lacking;
  }

  const model::Unit* unit_of(std::uint32_t device) const {
    return device < plant_.units.size() ? &plant_.units[device] : nullptr;  // else it has numbers only
  }

  const model::Symbol* find_symbol(std::uint32_t device, tables::Direction direction, std::string_view task) const {
    if (const model::Unit* unit = unit_of(device)) {
      const auto& side = direction == tables::Direction::operation ? unit->operations : unit->events;
      for (const std::uint32_t s : side) {
        if (text::equal_ignoring_case(plant_.symbols[s].reading.task(), task)) return &plant_.symbols[s];
      }
    }
    for (const DeviceClasses::Number& number : classes_.numbers_of(device)) {
      const model::Symbol& symbol = plant_.symbols[number.symbol];
      if (symbol.direction == direction && text::equal_ignoring_case(symbol.reading.task(), task)) return &symbol;
    }
    return nullptr;
  }

  void look_at(std::uint32_t device, std::size_t of) {
    const model::Unit* unit = unit_of(device);
    const std::string_view path =
        unit != nullptr ? unit->path : plant_.symbols[classes_.first_symbol(device)].reading.device_path();
    OddDevice odd{device, path, static_cast<std::uint32_t>(of), {}, false};
    bool other_task = false;
    for (const Common& common : common_) {
      if (find_symbol(device, common.direction, common.task) != nullptr) continue;
      odd.lacks.push_back({common.symbol, name_of(path, common), common.having});
      other_task = other_task || (unit != nullptr && is_of_other_task(*unit, common));
    }
    const std::size_t has = common_.size() - odd.lacks.size();
    odd.one_task = unit != nullptr && unit->rest_added && has != 0 && other_task;
    if (odd.lacks.empty() || (!odd.one_task && 2 * has < common_.size())) return;
    odd_.push_back(std::move(odd));
  }

  /// The name that the device's symbol would have. A custom rule reads names and does not write them.
  std::string name_of(std::string_view path, const Common& common) const {
    if (plant_.pairing != nullptr) return fmt::format("{} {}", path, common.task);
    return fmt::format("{}{}", path, common.symbol->name().substr(common.symbol->reading.device_path().size()));
  }

  /// Whether it is a bit of a task that the device does not have.
  static bool is_of_other_task(const model::Unit& unit, const Common& common) {
    return common.symbol->unmodelled != model::Unmodelled::numeric &&
           std::none_of(unit.states.begin(), unit.states.end(),
                        [&](const model::State& state) { return text::equal_ignoring_case(state.name, common.task); });
  }

  const model::PlantModel& plant_;
  const DeviceClasses& classes_;
  std::vector<Common> common_;  ///< of the current class
  std::vector<OddDevice> odd_;
};

}  // namespace

diag::Subjects about(const OddDevice& odd) {
  diag::Subjects subjects{{device(odd.path)}, {}, {device(odd.path), sequence_of(odd.path)}};
  for (const Lacking& lacking : odd.lacks) {
    subjects.about.push_back(missing(lacking.name));
    subjects.follows.push_back(missing(lacking.name));
    explain_missing(subjects, lacking.name, odd.path, lacking.others->direction);
  }
  return subjects;
}

std::vector<OddDevice> odd_devices(const Subject& subject) { return OddSearch(subject).find(); }

}  // namespace symplant::check
