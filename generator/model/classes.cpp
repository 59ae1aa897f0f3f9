// Names of classes, and what one behaviour may be for.
#include "model/classes.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "base/ascii.hpp"
#include "base/generated_names.hpp"
#include "base/identifier.hpp"

namespace symplant::model {
namespace {

using Symbols = std::vector<std::uint32_t>;

class Classes {
 public:
  Classes(const PlantModel& plant, Faults& faults) : plant_(plant), faults_(faults) {}

  void run() {
    for (const Unit& unit : plant_.units) {
      if (unit.described == nullptr) continue;
      const DeviceDescription& described = *unit.described;
      if (!described.type.empty()) {
        check_name(described.type, key_pointer(described, DeviceKey::type));
        types_.try_emplace(described.type, &unit);
      }
      check_inputs(described);
    }
    for (const Unit& unit : plant_.units) {
      if (unit.has_behaviour()) check_behaviour(unit);
    }
  }

 private:
  void check_name(const std::string& name, const Pointer& here) {
    if (!looked_at_.insert(here.text()).second) return;  // under a pattern: once, not once a device
    const std::string legal = base::identifier(name);
    if (legal != name) {
      faults_.add(here, ticked(name) + " is no name of a C++ class, write " + ticked(legal) + ", say");
      return;
    }
    const auto is_name = [&](std::string_view taken) { return base::equal_ignoring_case(taken, name); };
    if (std::any_of(base::kGeneratedNames.begin(), base::kGeneratedNames.end(), is_name)) {
      faults_.add(here, ticked(name) + " is a name that generated code uses itself, choose another");
    }
  }

  void check_inputs(const DeviceDescription& described) {
    if (!looked_at_.insert(key_pointer(described, DeviceKey::inputs).text()).second) return;
    base::ByName<bool> seen;
    for (const auto& [name, condition] : described.inputs) {
      const Pointer here = key_pointer(described, DeviceKey::inputs) / name;
      if (name.empty()) {
        faults_.add(here, "an input without a name, give it one");
      } else if (!seen.try_emplace(name, true).second) {
        faults_.add(here, ticked(name) + " names another input already, give each its own name");
      }
    }
  }

  void check_behaviour(const Unit& unit) {
    const std::string& name = unit.described->behaviour;
    const Pointer here = key_pointer(*unit.described, DeviceKey::behaviour);
    check_name(name, here);
    if (const auto type = types_.find(name); type != types_.end()) {
      faults_.add(here, ticked(name) + " is the `type` of " + ticked(type->second->path) +
                            " too, choose another name for the class that is derived from it");
    }
    const auto [found, added] = behaviours_.try_emplace(name, &unit);
    if (added) return;
    const Unit& first = *found->second;
    if (first.described->behaviour != name) {
      faults_.add(here, ticked(name) + " and " + ticked(first.described->behaviour) +
                            " differ by upper and lower case only, write them alike or choose another name");
      return;
    }
    const std::string_view other = difference(first, unit);
    if (other.empty()) return;
    faults_.add(here, ticked(name) + " is the behaviour of " + ticked(first.path) + " too, which has other " +
                          std::string(other) + ", choose another name for one of them");
  }

  /// What two devices do not have in common of what their behaviour's code sees; empty: all is alike.
  std::string_view difference(const Unit& a, const Unit& b) const {
    if (!same_tasks(a.operations, b.operations)) return "operations";
    if (!same_tasks(a.events, b.events)) return "events";
    const auto same_state = [](const State& x, const State& y) { return base::equal_ignoring_case(x.name, y.name); };
    if (!std::equal(a.states.begin(), a.states.end(), b.states.begin(), b.states.end(), same_state)) return "states";
    if (a.described->type != b.described->type) return "`type`";
    if (a.input_names != b.input_names) return "`inputs`";
    return same_tasks(a.values, b.values) ? "" : "numeric symbols";
  }

  bool same_tasks(const Symbols& a, const Symbols& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](std::uint32_t x, std::uint32_t y) {
      const Symbol& left = plant_.symbols[x];
      const Symbol& right = plant_.symbols[y];
      return base::equal_ignoring_case(left.reading.task, right.reading.task) && left.type == right.type &&
             left.direction == right.direction;
    });
  }

  const PlantModel& plant_;
  Faults& faults_;
  std::unordered_set<std::string> looked_at_;  // pointers
  base::ByName<const Unit*> types_;            // a given `type` -> the first device of it
  base::ByName<const Unit*> behaviours_;       // a behaviour -> likewise
};

}  // namespace

void check_classes(const PlantModel& plant, Faults& faults) { Classes(plant, faults).run(); }

}  // namespace symplant::model
