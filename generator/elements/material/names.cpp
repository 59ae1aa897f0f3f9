// Checks the names of kinds, tracks and places.
#include "elements/material/names.hpp"

#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::Pointer;
using description::ticked;

/// Why a text cannot be a name; empty if it can.
std::string why_no_name(std::string_view name) {
  if (name.empty()) return "this name is empty; write a name";
  for (const std::string_view word : {"out", "part", "parts"}) {
    if (text::equal_ignoring_case(name, word)) return ticked(name) + " is a reserved word; choose another name";
  }
  if (name.find('@') != name.npos) return ticked(name) + " has an `@`, which begins a position; choose another name";
  if (name.front() == ' ' || name.back() == ' ') return ticked(name) + " begins or ends with a blank; remove it";
  return {};
}

/// Reports a fault at the key of an entry. Of an entry with `for` only the first one is reported.
class NameFaults {
 public:
  explicit NameFaults(description::Faults& faults) : faults_(faults) {}

  void add(const Pointer& at, std::string message) {
    std::string pointer = at.text();
    if (!at.pattern_text().empty() && !reported_.insert(pointer).second) return;
    faults_.add({std::move(pointer), std::move(message), 0, description::FaultKind::contradiction, true});
  }

 private:
  description::Faults& faults_;
  std::unordered_set<std::string> reported_;
};

}  // namespace

std::vector<PartKind> checked_kinds(const std::vector<description::GivenKind>& given, description::Faults& faults) {
  std::vector<PartKind> kinds;
  kinds.reserve(given.size());
  text::ByName<bool> names;
  NameFaults found(faults);
  for (const description::GivenKind& kind : given) {
    const Pointer here = Pointer("/material/kinds") / std::string_view(kind.name);
    if (std::string why = why_no_name(kind.name); !why.empty()) {
      found.add(here, std::move(why));
    } else if (!names.try_emplace(kind.name, true).second) {
      found.add(here, ticked(kind.name) + " appears twice; remove one");
    }
    kinds.push_back({kind.name, kind.length, kind.code, kind.weight});
  }
  return kinds;
}

text::ByName<bool> names_of_devices(const PlantModel& plant, const MadeMaterial& made, description::Faults& faults) {
  text::ByName<bool> taken;  // by a device
  for (const Unit& unit : plant.units) {
    taken.try_emplace(unit.path, true);
    taken.try_emplace(unit.device_path(), true);
  }
  text::ByName<bool> rejected;
  NameFaults found(faults);
  const auto check = [&](const auto& entries, const std::vector<MadeBy>& origins, std::string_view list) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string& name = entries[i].name;
      std::string why = why_no_name(name);
      if (const auto [other, added] = taken.try_emplace(name, false); why.empty() && !added) {
        why = ticked(name) + (other->second ? " is the name of a device; choose another name"
                              : origins[i].pattern.empty()
                                  ? " already names another track or place; choose another name"
                                  : " already names another track or place; use `{self}` in the name");
      }
      if (why.empty()) continue;
      if (taken.at(name)) rejected.try_emplace(name, true);
      found.add(material_pointer(list, origins[i]), std::move(why));
    }
  };
  check(made.entries.tracks, made.tracks, "tracks");
  check(made.entries.places, made.places, "places");
  return rejected;
}

void check_tasks_of_sensors(const PlantModel& plant, description::Faults& faults) {
  text::ByName<const Unit*> units;
  for (const Unit& unit : plant.units) units.try_emplace(unit.path, &unit);
  for (const Symbol& symbol : plant.symbols) {
    if (symbol.account != Account::senses_parts || !symbol.reading.is_named()) continue;
    const auto unit = units.find(symbol.reading.device_path());
    if (unit == units.end() || unit->second->described == nullptr) continue;
    const description::DeviceDescription& described = *unit->second->described;
    for (std::size_t i = 0; i < described.states.size(); ++i) {
      if (!text::equal_ignoring_case(described.states[i], symbol.reading.task())) continue;
      faults.add(description::key_pointer(described, description::DeviceKey::states) / i,
                 ticked(described.states[i]) + " is the task of " + ticked(symbol.name()) +
                     ", which is a sensor of parts; choose another name");
    }
  }
}

}  // namespace symplant::model
