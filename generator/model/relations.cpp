// Resolves conditions, disables and requirements.
#include "model/relations.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "model/classes.hpp"
#include "model/given.hpp"
#include "model/plant_names.hpp"
#include "model/symbol_settings.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

/// The most pairs of a state and a device that it disables. More are a mistake and would not fit in memory.
constexpr std::size_t kMostDisabled = 10'000'000;

class Relations {
 public:
  Relations(PlantModel& plant, MadeNames& made, description::Faults& faults)
      : plant_(plant), made_(made), faults_(faults), names_(plant, faults) {}

  void run() {
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      Unit& unit = plant_.units[u];
      if (unit.described == nullptr) continue;
      add_conditions(unit);
      add_inputs(unit);
      add_disables(u);
    }
    check_classes(plant_, faults_);
    add_requirements();
    add_follows();
  }

 private:
  /// False, and a fault, if the text is not a condition of this plant.
  bool resolve(std::string_view text, const description::Pointer& pointer, condition::Tree& tree) {
    auto resolved = condition::parse_and_resolve(text, names_);
    if (auto* fault = std::get_if<condition::Fault>(&resolved)) {
      faults_.add(pointer, std::move(fault->message), description::FaultKind::condition, fault->index.offset);
      return false;
    }
    tree = std::move(std::get<condition::Tree>(resolved));
    return true;
  }

  /// As resolve(), for a text under a pattern, in which names in braces refer to `matched`. It may be left out: then
  /// `lacking` is what the plant lacks.
  bool resolve_made(const std::string& text, const MatchedNames& matched, const description::Pointer& pointer,
                    condition::Tree& tree, std::string* lacking = nullptr) {
    if (!text::has_braces(text)) return resolve(text, pointer, tree);
    const auto made = make(text, matched, pointer);
    if (!made) return false;
    auto parsed = condition::parse(*made);
    auto* fault = std::get_if<condition::Fault>(&parsed);
    if (fault == nullptr) {
      auto resolved = condition::resolve(std::get<condition::Expression>(parsed), names_);
      if (auto* found = std::get_if<condition::Tree>(&resolved)) {
        tree = std::move(*found);
        return true;
      }
      std::string& message = std::get<condition::Fault>(resolved).message;
      if (lacking != nullptr) {
        *lacking = std::move(message);
        return false;
      }
      faults_.add(pointer, std::move(message), description::FaultKind::condition);
      return false;
    }
    faults_.add(pointer, description::ticked(*made) + ": " + fault->message, description::FaultKind::condition);
    return false;
  }

  /// The text with names for those in braces; nothing, and a fault, if one is unknown.
  std::optional<std::string> make(const std::string& text, const MatchedNames& matched,
                                  const description::Pointer& pointer) {
    text::Replaced made = matched.replace(text);
    if (made.unknown.empty()) return std::move(made.text);
    faults_.add(pointer, description::ticked(made.unknown) + " is unknown here; use one of " + matched.choices(),
                description::FaultKind::unknown_name);
    return std::nullopt;
  }

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
      known->second = resolve_made(text, *matched, here, tree);
      if (added) unit.conditions.push_back(std::move(tree));
    };
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (std::binary_search(unit.left_out.begin(), unit.left_out.end(), i)) continue;
      add(given[i].when, pointer / i / "when");
      add(given[i].during, pointer / i / "while");
    }
    unit.first_input = static_cast<std::uint32_t>(unit.conditions.size());
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
        resolve_made(given[i].second, matched_by(unit, description::DeviceKey::inputs), here, tree, &lacking);
        made_.takes(here);
      } else {
        resolve(given[i].second, here, tree);
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
      const auto made =
          is_made ? make(entry.devices[i], matched_by(plant_.units[by], description::DeviceKey::disables), here / i)
                  : std::optional(entry.devices[i]);
      if (!made) continue;
      const std::string& device = *made;
      if (is_made) made_.takes(here / i);
      if (device.find_first_of("*?") != std::string::npos) {
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

  void add_requirements() {
    const auto& given = plant_.description->requirements;
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      const description::Pointer here = description::Pointer("/requirements") / std::size_t{i};
      if (given[i].name.empty()) faults_.add(here / "name", "this requirement has no name; give it one");
      const bool never = !given[i].never.empty();
      if (never == (!given[i].after.empty() || !given[i].expect.empty()) ||
          given[i].after.empty() != given[i].expect.empty()) {
        faults_.add(here, "a requirement needs either `never`, or `after` with `expect`");
      } else if (given[i].of.empty()) {
        if (!refuse_braces(given[i], here)) add_requirement(i, nullptr, {}, here);
      } else {
        add_requirements_for(i, here.matched_by(given[i].of));
      }
    }
  }

  /// Whether a requirement without `for` has names in braces, which is a fault. In quotes they may be part of a name.
  bool refuse_braces(const description::GivenRequirement& given, const description::Pointer& here) {
    bool refused = false;
    for (const auto& [text, key] : {std::pair<const std::string&, std::string_view>(given.name, "name"),
                                    {given.never, "never"},
                                    {given.after, "after"},
                                    {given.expect, "expect"}}) {
      const std::size_t open = text.find('{');
      if (open == text.npos || (key != "name" && text.find('\'') < open)) continue;
      faults_.add(here / key, description::ticked(text.substr(open, text.find('}', open) + 1 - open)) +
                                  " is replaced by a name only with `for`; add `for`, or write the name");
      refused = true;
    }
    return refused;
  }

  /// One requirement for each device that `for` matches.
  void add_requirements_for(std::uint32_t index, const description::Pointer& here) {
    const std::string& pattern = plant_.description->requirements[index].of;
    std::unordered_set<std::string_view> devices;
    for (const Unit& unit : plant_.units) {
      if (!text::matches_pattern(unit.device_path(), pattern) || !devices.insert(unit.device_path()).second) continue;
      const MatchedNames matched = MatchedNames::of(plant_, unit, pattern);
      add_requirement(index, &matched, unit.device_path(), here);
    }
    if (devices.empty()) {
      faults_.warn(here / "for", description::ticked(pattern) + " matches no device",
                   description::FaultKind::matches_nothing);
    }
  }

  /// `matched` is null without `for`.
  void add_requirement(std::uint32_t index, const MatchedNames* matched, std::string_view device,
                       const description::Pointer& here) {
    const description::GivenRequirement& given = plant_.description->requirements[index];
    Requirement requirement;
    requirement.given = index;
    requirement.kind = given.never.empty() ? tables::RequirementRow::Kind::expect : tables::RequirementRow::Kind::never;
    requirement.within = given.within;
    requirement.earliest = given.earliest;
    requirement.name = given.name;
    if (matched != nullptr && text::has_braces(given.name)) {
      auto name = make(given.name, *matched, here / "name");
      if (!name) return;
      requirement.name = std::move(*name);
    }
    std::string lacking;
    const auto read = [&](const std::string& text, std::string_view key, condition::Tree& tree) {
      if (text.empty()) return true;
      return matched == nullptr ? resolve(text, here / key, tree)
                                : resolve_made(text, *matched, here / key, tree, &lacking);
    };
    bool sound = read(given.never, "never", requirement.condition);
    sound = read(given.after, "after", requirement.condition) && sound;
    sound = read(given.expect, "expect", requirement.expected) && sound;
    if (matched != nullptr) made_.takes(here);
    if (!lacking.empty()) made_.lacks(here, device, std::move(lacking));
    if (requirement.name.empty() || !sound) return;
    if (!requirement_names_.insert(requirement.name).second) {
      faults_.add(here / "name", description::ticked(requirement.name) + " already names another requirement; " +
                                     (matched == nullptr ? "choose another name" : "use `{self}` in the name"));
    }
    plant_.requirements.push_back(std::move(requirement));
  }

  void add_follows() {
    std::vector<Follow> follows;
    follows.reserve(plant_.follows.size());
    for (Follow& follow : plant_.follows) {
      const description::GivenFollow& given = plant_.description->follow[follow.given];
      const description::Pointer here = follow_pointer(plant_, follow.given);
      const bool is_pattern = given.symbol.find_first_of("*?") != std::string::npos;
      Symbol& symbol = plant_.symbols[follow.symbol];
      std::string lacking;
      const bool sound = is_pattern ? resolve_made(given.condition, MatchedNames::of(symbol, given.symbol),
                                                   here.matched_by(given.symbol), follow.condition, &lacking)
                                    : resolve(given.condition, here, follow.condition);
      if (is_pattern) made_.takes(here);
      if (!lacking.empty()) made_.lacks(here, symbol.name(), std::move(lacking));
      if (sound) {
        follows.push_back(std::move(follow));
      } else {
        symbol.account = name::unpaired(symbol.direction);
      }
    }
    plant_.follows = std::move(follows);
    check_follow_cycles(plant_, faults_);
  }

  PlantModel& plant_;
  MadeNames& made_;
  description::Faults& faults_;
  PlantNames names_;
  std::unordered_map<std::string, std::vector<std::uint32_t>> matching_;  // of `disables`: a pattern -> its units
  std::size_t disabled_ = 0;
  std::unordered_set<std::string> requirement_names_;
};

}  // namespace

void add_relations(PlantModel& plant, MadeNames& made, description::Faults& faults) {
  const bool described = !plant.description->devices.empty() || plant.pairing != nullptr;
  if (!described && plant.description->requirements.empty() && plant.follows.empty()) return;
  Relations(plant, made, faults).run();
}

}  // namespace symplant::model
