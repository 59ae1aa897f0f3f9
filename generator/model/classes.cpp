// Checks the names of classes, and the devices of each behavior.
#include "model/classes.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "text/ascii.hpp"
#include "text/generated_names.hpp"
#include "text/identifier.hpp"

namespace symplant::model {
namespace {

using Symbols = std::vector<std::uint32_t>;

class Classes {
 public:
  Classes(const PlantModel& plant, description::Faults& faults) : plant_(plant), faults_(faults) {}

  void run() {
    for (const Unit& unit : plant_.units) {
      if (unit.described == nullptr) continue;
      const description::DeviceDescription& described = *unit.described;
      if (!described.type.empty()) {
        check_name(described.type, description::key_pointer(described, description::DeviceKey::type));
        types_.try_emplace(described.type, &unit);
      }
      check_inputs(described);
    }
    for (const Unit& unit : plant_.units) {
      if (unit.has_behaviour()) check_behaviour(unit);
    }
  }

 private:
  void check_name(const std::string& name, const description::Pointer& here) {
    if (!looked_at_.insert(here.text()).second) return;  // under a pattern: once, not for each device
    const std::string legal = text::identifier(name);
    if (legal != name) {
      faults_.add(here, description::ticked(name) + " is not a valid C++ class name; write " +
                            description::ticked(legal) + ", for example");
      return;
    }
    const auto is_name = [&](std::string_view taken) { return text::equal_ignoring_case(taken, name); };
    if (std::any_of(text::kGeneratedNames.begin(), text::kGeneratedNames.end(), is_name)) {
      faults_.add(here, description::ticked(name) + " is a name that generated code uses itself; choose another");
    }
  }

  void check_inputs(const description::DeviceDescription& described) {
    if (described.inputs.empty()) return;
    if (!looked_at_.insert(description::key_pointer(described, description::DeviceKey::inputs).text()).second) return;
    text::ByName<bool> seen;
    for (const auto& [name, condition] : described.inputs) {
      const description::Pointer here = description::key_pointer(described, description::DeviceKey::inputs) / name;
      if (name.empty()) {
        faults_.add(here, "this input has no name; give it one");
      } else if (!seen.try_emplace(name, true).second) {
        faults_.add(here, description::ticked(name) + " already names another input; choose another name");
      }
    }
  }

  void check_behaviour(const Unit& unit) {
    const std::string& name = unit.described->behaviour;
    const description::Pointer here = description::key_pointer(*unit.described, description::DeviceKey::behaviour);
    check_name(name, here);
    if (const auto type = types_.find(name); type != types_.end()) {
      faults_.add(here, description::ticked(name) + " is also the `type` of " +
                            description::ticked(type->second->path) + "; choose another name for the derived class");
    }
    const auto [found, added] = behaviours_.try_emplace(name, &unit);
    if (added) return;
    const Unit& first = *found->second;
    if (first.described->behaviour != name) {
      faults_.add(here, description::ticked(name) + " and " + description::ticked(first.described->behaviour) +
                            " differ only in case; write them the same or choose another name");
      return;
    }
    const std::string_view other = difference(first, unit);
    if (other.empty()) return;
    faults_.add(here, description::ticked(name) + " is also the `behaviour` of " + description::ticked(first.path) +
                          ", which has other " + std::string(other) +
                          ", or the same in another order; choose another name for one of them");
  }

  /// The first difference between two devices that the code of their behavior sees; empty: none.
  std::string_view difference(const Unit& a, const Unit& b) const {
    if (!same_tasks(a.operations, b.operations)) return "operations";
    if (!same_tasks(a.events, b.events)) return "events";
    const auto same_state = [](const State& x, const State& y) { return text::equal_ignoring_case(x.name, y.name); };
    if (!std::equal(a.states.begin(), a.states.end(), b.states.begin(), b.states.end(), same_state)) return "states";
    if (a.described->type != b.described->type) return "`type`";
    if (a.input_names != b.input_names) return "`inputs`";
    return same_tasks(a.values, b.values) ? "" : "numeric symbols";
  }

  bool same_tasks(const Symbols& a, const Symbols& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](std::uint32_t x, std::uint32_t y) {
      const Symbol& left = plant_.symbols[x];
      const Symbol& right = plant_.symbols[y];
      return text::equal_ignoring_case(left.reading.task(), right.reading.task()) && left.type == right.type &&
             left.direction == right.direction;
    });
  }

  const PlantModel& plant_;
  description::Faults& faults_;
  std::unordered_set<std::string> looked_at_;  // pointers
  text::ByName<const Unit*> types_;            // a given `type` -> the first device of it
  text::ByName<const Unit*> behaviours_;       // a behavior -> the first device of it
};

}  // namespace

void check_classes(const PlantModel& plant, description::Faults& faults) { Classes(plant, faults).run(); }

}  // namespace symplant::model
