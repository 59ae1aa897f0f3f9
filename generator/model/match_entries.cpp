// Matches entries of the description with devices, and joins them.
#include "model/match_entries.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

constexpr std::size_t kMoreThanAnyPattern = std::size_t{0} - 1;

/// An entry whose name is a pattern.
struct Pattern {
  const description::DeviceDescription* entry;
  std::size_t literals;  ///< characters other than `*` and `?`: how specific it is
  std::size_t matched = 0;
};

class EntryMatcher {
 public:
  EntryMatcher(PlantModel& plant, description::Faults& faults) : plant_(plant), faults_(faults) {}

  /// How many devices each pattern matches, in words.
  std::vector<std::string> run() {
    std::vector<std::string> decisions;
    std::vector<const description::DeviceDescription*> exact(plant_.units.size());
    find_exact(exact);
    find_patterns();
    std::vector<const description::DeviceDescription*> entries;
    for (std::size_t u = 0; u < plant_.units.size(); ++u) {
      Unit& unit = plant_.units[u];
      entries.clear();
      for (Pattern& pattern : patterns_) {
        if (!pattern.entry->matches(unit.path, unit.device_path())) continue;
        ++pattern.matched;
        entries.push_back(pattern.entry);
      }
      unit.described = joined(unit, exact[u], entries);
    }
    for (const Pattern& pattern : patterns_) {
      if (pattern.entry->covers_facets) continue;
      decisions.push_back(description::ticked(pattern.entry->path) + " matches " + std::to_string(pattern.matched) +
                          (pattern.matched == 1 ? " device" : " devices"));
      if (pattern.matched != 0) continue;
      faults_.warn(description::device_pointer(*pattern.entry),
                   description::ticked(pattern.entry->path) + " matches no device",
                   description::FaultKind::matches_nothing);
    }
    return decisions;
  }

 private:
  void find_exact(std::vector<const description::DeviceDescription*>& exact) {
    text::ByName<std::size_t> by_path;
    by_path.reserve(plant_.units.size());
    for (std::size_t u = 0; u < plant_.units.size(); ++u) by_path.try_emplace(plant_.units[u].path, u);
    for (const description::DeviceDescription& device : plant_.description->devices) {
      if (device.is_pattern()) continue;
      const auto found = by_path.find(device.path);
      if (found == by_path.end() && covers_facets(device)) continue;
      if (found == by_path.end() && device.names_symbols()) continue;  // its symbols have faults, which are reported
      if (found == by_path.end()) {
        const auto nearest =
            faults_.nearest(device.path, plant_.units.size(), [&](std::size_t i) { return plant_.units[i].path; });
        faults_.add(description::device_pointer(device),
                    description::missing("device " + description::ticked(device.path), nearest),
                    description::FaultKind::unknown_name);
      } else if (exact[found->second] != nullptr) {
        description::DescriptionFault fault{description::device_pointer(device).text(),
                                            description::ticked(device.path) + " is described twice; merge both"};
        fault.related = description::device_pointer(*exact[found->second]).text();
        fault.related_message = "the other description";
        faults_.add(std::move(fault));
      } else {
        exact[found->second] = &device;
      }
    }
  }

  /// Whether the entry names a device with several facets: then it is a pattern for all of them.
  bool covers_facets(const description::DeviceDescription& device) {
    if (facets_.empty()) {
      for (const Unit& unit : plant_.units) {
        if (unit.facet != nullptr) facets_.try_emplace(unit.facet->path, true);
      }
    }
    if (!facets_.contains(device.path)) return false;
    description::DeviceDescription copy = device;
    copy.covers_facets = true;
    patterns_.push_back({keep(std::move(copy)), kMoreThanAnyPattern});
    return true;
  }

  /// Sorts patterns: the most specific first, equal ones in the order of the file.
  void find_patterns() {
    for (const description::DeviceDescription& device : plant_.description->devices) {
      if (device.is_pattern()) patterns_.push_back({&device, text::literal_characters(device.path)});
    }
    std::stable_sort(patterns_.begin(), patterns_.end(),
                     [](const Pattern& a, const Pattern& b) { return a.literals > b.literals; });
  }

  const description::DeviceDescription* joined(const Unit& unit, const description::DeviceDescription* exact,
                                               const std::vector<const description::DeviceDescription*>& patterns) {
    const description::DeviceDescription* by_naming = unit.facet == nullptr ? nullptr : unit.facet->base.get();
    if (patterns.empty() && (exact == nullptr || by_naming == nullptr)) return exact == nullptr ? by_naming : exact;
    if (exact != nullptr || by_naming != nullptr) return keep(join(unit, exact, patterns, by_naming));
    if (patterns.size() == 1) return patterns.front();
    const description::DeviceDescription*& known = by_patterns_[patterns];
    if (known == nullptr) known = keep(join(unit, nullptr, patterns, nullptr));
    return known;
  }

  const description::DeviceDescription* keep(description::DeviceDescription described) {
    plant_.joined.push_back(std::make_shared<const description::DeviceDescription>(std::move(described)));
    return plant_.joined.back().get();
  }

  description::DeviceDescription join(const Unit& unit, const description::DeviceDescription* exact,
                                      const std::vector<const description::DeviceDescription*>& patterns,
                                      const description::DeviceDescription* by_naming) {
    description::DeviceDescription all;
    all.path = (exact != nullptr ? exact : patterns.front())->path;
    for (std::size_t k = 0; k < description::kDeviceKeys; ++k) {
      const auto key = static_cast<description::DeviceKey>(k);
      if (exact != nullptr && exact->gives(key)) {
        all.take(key, *exact);
      } else if (const description::DeviceDescription* best = best_of(unit, patterns, key); best != nullptr) {
        all.take(key, *best);
      } else if (by_naming != nullptr && by_naming->gives(key)) {
        all.take(key, *by_naming);
      }
    }
    return all;
  }

  /// The first pattern that gives the key; equally specific ones must agree with it.
  const description::DeviceDescription* best_of(const Unit& unit,
                                                const std::vector<const description::DeviceDescription*>& patterns,
                                                description::DeviceKey key) {
    const description::DeviceDescription* best = nullptr;
    for (const description::DeviceDescription* pattern : patterns) {
      if (!pattern->gives(key)) continue;
      if (best == nullptr) {
        best = pattern;
      } else if (best->covers_facets ||
                 text::literal_characters(pattern->path) != text::literal_characters(best->path)) {
        break;
      } else if (text_of(*pattern, key) != text_of(*best, key)) {
        contradiction(unit, *best, *pattern, key);
      }
    }
    return best;
  }

  static std::string_view text_of(const description::DeviceDescription& entry, description::DeviceKey key) {
    const auto index = static_cast<std::size_t>(key);
    return index < entry.texts.size() ? std::string_view(entry.texts[index]) : std::string_view();
  }

  void contradiction(const Unit& unit, const description::DeviceDescription& first,
                     const description::DeviceDescription& second, description::DeviceKey key) {
    if (!contradictions_
             .insert({description::key_pointer(first, key).text(), description::key_pointer(second, key).text()})
             .second)
      return;
    description::DescriptionFault fault{
        description::key_pointer(second, key).text(),
        description::ticked(second.path) + " and " + description::ticked(first.path) +
            " are equally specific and give `" + std::string(description::device_key_name(key)) + "` of " +
            description::ticked(unit.path) + " different values; make one more specific or name the device"};
    fault.kind = description::FaultKind::patterns;
    fault.at_key = true;
    fault.related = description::key_pointer(first, key).text();
    fault.related_message = "the other value";
    faults_.add(std::move(fault));
  }

  PlantModel& plant_;
  description::Faults& faults_;
  std::vector<Pattern> patterns_;
  text::ByName<bool> facets_;  ///< devices of facets
  std::map<std::vector<const description::DeviceDescription*>, const description::DeviceDescription*>
      by_patterns_;  // never iterated
  std::set<std::pair<std::string, std::string>> contradictions_;
};

}  // namespace

std::vector<std::string> match_entries(PlantModel& plant, description::Faults& faults) {
  if (plant.description->devices.empty() && plant.pairing == nullptr) return {};
  return EntryMatcher(plant, faults).run();
}

namespace {

bool has(const PlantModel& plant, const Unit& unit, description::Named what, std::string_view name) {
  if (what == description::Named::state) {
    return std::any_of(unit.states.begin(), unit.states.end(),
                       [&](const State& state) { return text::equal_ignoring_case(state.name, name); });
  }
  const std::vector<std::uint32_t>& side = what == description::Named::operation ? unit.operations : unit.events;
  return std::any_of(side.begin(), side.end(), [&](std::uint32_t symbol) {
    return text::equal_ignoring_case(plant.symbols[symbol].reading.task(), name);
  });
}

}  // namespace

void report_lacks(const PlantModel& plant, description::Faults& faults) {
  faults.report_lacks([&](std::string_view pattern, description::Named what, std::string_view name) {
    return std::any_of(plant.units.begin(), plant.units.end(), [&](const Unit& unit) {
      return (text::matches_pattern(unit.path, pattern) || text::matches_pattern(unit.device_path(), pattern)) &&
             has(plant, unit, what, name);
    });
  });
}

}  // namespace symplant::model
