// Resolves the conditions, inputs and disables of devices.
#include "model/relations.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "model/classes.hpp"
#include "model/given.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

/// The most pairs of a state and a device that it disables. More are a mistake and would not fit in memory.
constexpr std::size_t kMostDisabled = 10'000'000;

class Relations {
 public:
  Relations(PlantModel& plant, ConditionReader& conditions, TimeFormulas& times, MadeNames& made,
            description::Faults& faults)
      : plant_(plant),
        conditions_(conditions),
        names_(conditions.names()),
        times_(times),
        made_(made),
        faults_(faults) {}

  void run() {
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      Unit& unit = plant_.units[u];
      if (unit.described == nullptr) continue;
      add_conditions(unit);
      add_times(unit);
      add_inputs(unit);
      add_disables(u);
    }
    check_classes(plant_, faults_);
  }

 private:
  MatchedNames matched_by(const Unit& unit, description::DeviceKey key) const {
    return MatchedNames::of(plant_, unit, unit.described->entry_of(key).path);
  }

  /// One condition for each text, in the order of first appearance, as Transition::when and Transition::during count
  /// them. A faulty one also has an index, and its fault is reported at each use.
  void add_conditions(Unit& unit) {
    std::unordered_map<std::string_view, bool> sound;
    const auto& given = unit.described->transitions;
    std::optional<MatchedNames> matched;
    const description::Pointer pointer = description::key_pointer(*unit.described, description::DeviceKey::transitions);
    const auto add = [&](const std::string& text, const description::Pointer& here) {
      if (text.empty()) return;
      const auto [known, added] = sound.try_emplace(text, true);
      if (!added && known->second) return;
      condition::Tree tree;
      if (!matched) matched = matched_by(unit, description::DeviceKey::transitions);
      known->second = conditions_.resolve_made(text, *matched, here, tree);
      if (added) unit.conditions.push_back(std::move(tree));
    };
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (std::binary_search(unit.left_out.begin(), unit.left_out.end(), i)) continue;
      add(given[i].when, pointer / i / "when");
      add(given[i].during, pointer / i / "while");
    }
    unit.first_input = static_cast<std::uint32_t>(unit.conditions.size());
  }

  /// Resolves the formulas of times; a faulty one is 0.
  void add_times(Unit& unit) {
    const description::Pointer pointer = description::key_pointer(*unit.described, description::DeviceKey::transitions);
    for (Transition& transition : unit.transitions) {
      if (transition.given == kNone) continue;
      const description::Pointer here = pointer / std::size_t{transition.given};
      add_time(unit, transition.after, here / "after" / "seconds");
      add_time(unit, transition.takes, here / "takes" / "seconds");
    }
  }

  void add_time(const Unit& unit, description::Duration& time, const description::Pointer& here) {
    const std::string_view pattern = unit.described->entry_of(description::DeviceKey::transitions).path;
    if (!times_.resolve(unit, pattern, here, time)) time = description::Duration::fixed(0);
  }

  /// Sorted by name, since an object of JSON has no order. Without a behavior inputs are only checked.
  void add_inputs(Unit& unit) {
    const auto& given = unit.described->inputs;
    std::vector<std::size_t> order(given.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return given[a].first < given[b].first; });
    for (const std::size_t i : order) {
      condition::Tree tree;
      const description::Pointer here =
          description::key_pointer(*unit.described, description::DeviceKey::inputs) / given[i].first;
      std::string lacking;
      if (text::has_braces(given[i].second)) {
        conditions_.resolve_made(given[i].second, matched_by(unit, description::DeviceKey::inputs), here, tree,
                                 &lacking);
        made_.takes(here);
      } else {
        conditions_.resolve(given[i].second, here, tree);
      }
      if (!lacking.empty()) {
        made_.lacks(here, unit.path, std::move(lacking), given[i].second);
        continue;
      }
      if (unit.described->behaviour.empty()) continue;
      unit.conditions.push_back(std::move(tree));
      unit.input_names.push_back(given[i].first);
    }
  }

  void add_disables(std::uint32_t by) {
    Unit& unit = plant_.units[by];
    const auto& given = unit.described->disables;
    if (given.empty()) return;
    unit.disables.resize(unit.states.size());
    std::vector<bool> seen(unit.states.size());
    for (const description::GivenDisables& entry : given) {
      const description::Pointer here =
          description::key_pointer(*unit.described, description::DeviceKey::disables) / entry.state;
      const std::uint32_t state = given_state(unit, entry.state, here, faults_);
      if (state != kNone && seen[state])
        faults_.add(here, description::ticked(entry.state) + " appears twice; merge both");
      if (state != kNone) seen[state] = true;
      std::vector<std::uint32_t> disabled = disabled_units(by, entry, here, state != kNone);
      if (state != kNone) unit.disables[state] = std::move(disabled);
    }
  }

  std::vector<std::uint32_t> disabled_units(std::uint32_t by, const description::GivenDisables& entry,
                                            const description::Pointer& here, bool has_state) {
    std::vector<std::uint32_t> disabled;
    for (std::size_t i = 0; i < entry.devices.size(); ++i) {
      const bool is_made = text::has_braces(entry.devices[i]);
      const auto made = is_made
                            ? conditions_.make(entry.devices[i],
                                               matched_by(plant_.units[by], description::DeviceKey::disables), here / i)
                            : std::optional(entry.devices[i]);
      if (!made) continue;
      const std::string& device = *made;
      if (is_made) made_.takes(here / i);
      if (text::is_pattern(device)) {
        for (const std::uint32_t unit : matching(device, here / i)) {
          if (unit != by) disabled.push_back(unit);
        }
        continue;
      }
      const auto unit = names_.unit(device, {});
      if (const std::vector<std::uint32_t> facets = names_.facets(device); !facets.empty()) {
        std::copy_if(facets.begin(), facets.end(), std::back_inserter(disabled),
                     [&](std::uint32_t facet) { return facet != by; });
        if (unit && *unit != by) disabled.push_back(*unit);
      } else if (!unit) {
        std::string message =
            description::missing("device " + description::ticked(device), names_.nearest_device(device, {}));
        if (is_made) {
          made_.lacks(here / i, plant_.units[by].path, std::move(message), entry.devices[i]);
        } else {
          faults_.add(here / i, std::move(message), description::FaultKind::unknown_name);
        }
      } else if (*unit == by) {
        // A device that lacks the state of a pattern is not reported.
        if (has_state) faults_.add(here / i, description::ticked(device) + " disables itself; remove it");
      } else {
        disabled.push_back(*unit);
      }
    }
    std::sort(disabled.begin(), disabled.end());
    disabled.erase(std::unique(disabled.begin(), disabled.end()), disabled.end());
    disabled_ += disabled.size();
    if (disabled_ <= kMostDisabled) return disabled;
    if (disabled_ - disabled.size() <= kMostDisabled) {
      faults_.add(here, "`disables` names more than " + std::to_string(kMostDisabled) +
                            " devices in the whole plant; name fewer");
    }
    return {};
  }

  /// The units that a pattern matches.
  const std::vector<std::uint32_t>& matching(const std::string& pattern, const description::Pointer& here) {
    const auto [found, added] = matching_.try_emplace(pattern);
    if (!added) return found->second;
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      const Unit& unit = plant_.units[u];
      if (text::matches_pattern(unit.path, pattern) || text::matches_pattern(unit.device_path(), pattern)) {
        found->second.push_back(u);
      }
    }
    if (found->second.empty())
      faults_.warn(here, description::ticked(pattern) + " matches no device", description::FaultKind::matches_nothing);
    return found->second;
  }

  PlantModel& plant_;
  ConditionReader& conditions_;
  const PlantNames& names_;
  TimeFormulas& times_;
  MadeNames& made_;
  description::Faults& faults_;
  std::unordered_map<std::string, std::vector<std::uint32_t>> matching_;  // of `disables`: a pattern -> its units
  std::size_t disabled_ = 0;
};

}  // namespace

void add_relations(PlantModel& plant, ConditionReader& conditions, TimeFormulas& times, MadeNames& made,
                   description::Faults& faults) {
  Relations(plant, conditions, times, made, faults).run();
}

}  // namespace symplant::model
