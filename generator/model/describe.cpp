// Entries of the description matched with devices and joined.
#include "model/describe.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/ascii.hpp"
#include "base/pattern.hpp"

namespace symplant::model {
namespace {

/// An entry whose name is a pattern.
struct Pattern {
  const DeviceDescription* entry;
  std::size_t literals;  ///< how specific it is
  std::size_t matched = 0;
};

class Describer {
 public:
  Describer(PlantModel& plant, Faults& faults) : plant_(plant), faults_(faults) {}

  void run() {
    std::vector<const DeviceDescription*> exact(plant_.units.size());
    find_exact(exact);
    find_patterns();
    std::vector<const DeviceDescription*> entries;
    for (std::size_t u = 0; u < plant_.units.size(); ++u) {
      Unit& unit = plant_.units[u];
      entries.clear();
      for (Pattern& pattern : patterns_) {
        if (!base::matches_pattern(unit.path, pattern.entry->path)) continue;
        ++pattern.matched;
        entries.push_back(pattern.entry);
      }
      unit.described = joined(unit, exact[u], entries);
    }
    for (const Pattern& pattern : patterns_) {
      plant_.description_decisions.push_back(ticked(pattern.entry->path) + " speaks of " +
                                             std::to_string(pattern.matched) +
                                             (pattern.matched == 1 ? " device" : " devices"));
      if (pattern.matched != 0) continue;
      faults_.warn(device_pointer(*pattern.entry), ticked(pattern.entry->path) + " matches no device",
                   FaultKind::matches_nothing);
    }
  }

 private:
  void find_exact(std::vector<const DeviceDescription*>& exact) {
    base::ByName<std::size_t> by_path;
    by_path.reserve(plant_.units.size());
    for (std::size_t u = 0; u < plant_.units.size(); ++u) by_path.try_emplace(plant_.units[u].path, u);
    for (const DeviceDescription& device : plant_.description->devices) {
      if (device.is_pattern()) continue;
      const auto found = by_path.find(device.path);
      if (found == by_path.end()) {
        const auto nearest =
            faults_.nearest(device.path, plant_.units.size(), [&](std::size_t i) { return plant_.units[i].path; });
        faults_.add(device_pointer(device), missing("device " + ticked(device.path), nearest), FaultKind::unknown_name);
      } else if (exact[found->second] != nullptr) {
        DescriptionFault fault{device_pointer(device).text(), ticked(device.path) + " is described twice, join both"};
        fault.related = device_pointer(*exact[found->second]).text();
        fault.related_message = "the other description";
        faults_.add(std::move(fault));
      } else {
        exact[found->second] = &device;
      }
    }
  }

  /// The most specific first, of equal ones in the order of the file.
  void find_patterns() {
    for (const DeviceDescription& device : plant_.description->devices) {
      if (device.is_pattern()) patterns_.push_back({&device, base::literal_characters(device.path)});
    }
    std::stable_sort(patterns_.begin(), patterns_.end(),
                     [](const Pattern& a, const Pattern& b) { return a.literals > b.literals; });
  }

  const DeviceDescription* joined(const Unit& unit, const DeviceDescription* exact,
                                  const std::vector<const DeviceDescription*>& patterns) {
    if (patterns.empty()) return exact;
    if (exact != nullptr) return keep(join(unit, exact, patterns));
    if (patterns.size() == 1) return patterns.front();
    const DeviceDescription*& known = by_patterns_[patterns];
    if (known == nullptr) known = keep(join(unit, nullptr, patterns));
    return known;
  }

  const DeviceDescription* keep(DeviceDescription described) {
    plant_.joined.push_back(std::make_shared<const DeviceDescription>(std::move(described)));
    return plant_.joined.back().get();
  }

  DeviceDescription join(const Unit& unit, const DeviceDescription* exact,
                         const std::vector<const DeviceDescription*>& patterns) {
    DeviceDescription all;
    all.path = (exact != nullptr ? exact : patterns.front())->path;
    for (std::size_t k = 0; k < kDeviceKeys; ++k) {
      const auto key = static_cast<DeviceKey>(k);
      if (exact != nullptr && exact->gives(key)) {
        all.take(key, *exact);
      } else if (const DeviceDescription* best = best_of(unit, patterns, key); best != nullptr) {
        all.take(key, *best);
      }
    }
    return all;
  }

  /// The first that gives the key. Others as specific as it must agree.
  const DeviceDescription* best_of(const Unit& unit, const std::vector<const DeviceDescription*>& patterns,
                                   DeviceKey key) {
    const DeviceDescription* best = nullptr;
    for (const DeviceDescription* pattern : patterns) {
      if (!pattern->gives(key)) continue;
      if (best == nullptr) {
        best = pattern;
      } else if (base::literal_characters(pattern->path) != base::literal_characters(best->path)) {
        break;
      } else if (text_of(*pattern, key) != text_of(*best, key)) {
        contradiction(unit, *best, *pattern, key);
      }
    }
    return best;
  }

  static std::string_view text_of(const DeviceDescription& entry, DeviceKey key) {
    const auto place = static_cast<std::size_t>(key);
    return place < entry.texts.size() ? std::string_view(entry.texts[place]) : std::string_view();
  }

  void contradiction(const Unit& unit, const DeviceDescription& first, const DeviceDescription& second, DeviceKey key) {
    if (!contradictions_.insert({key_pointer(first, key).text(), key_pointer(second, key).text()}).second) return;
    DescriptionFault fault{key_pointer(second, key).text(),
                           ticked(second.path) + " and " + ticked(first.path) + " are equally specific and give `" +
                               std::string(device_key_name(key)) + "` of " + ticked(unit.path) +
                               " different values, make one more specific or name the device"};
    fault.kind = FaultKind::patterns;
    fault.at_key = true;
    fault.related = key_pointer(first, key).text();
    fault.related_message = "the other value";
    faults_.add(std::move(fault));
  }

  PlantModel& plant_;
  Faults& faults_;
  std::vector<Pattern> patterns_;
  std::map<std::vector<const DeviceDescription*>, const DeviceDescription*> by_patterns_;  // never walked
  std::set<std::pair<std::string, std::string>> contradictions_;
};

}  // namespace

void describe_units(PlantModel& plant, Faults& faults) {
  if (!plant.description->devices.empty()) Describer(plant, faults).run();
}

}  // namespace symplant::model
