// Resolves the malfunctions of the description.
#include "elements/malfunction/resolve.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include "elements/malfunction/resolve_effect.hpp"
#include "model/plant_names.hpp"
#include "symplant/condition/resolve.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

/// The text before the ending; empty if it does not end so.
std::string_view before(std::string_view name, std::string_view ending) {
  if (name.size() <= ending.size()) return {};
  const std::size_t length = name.size() - ending.size();
  return text::equal_ignoring_case(name.substr(length), ending) ? name.substr(0, length) : std::string_view();
}

/// Whether a text is `UNIT stuck`, `UNIT slow`, `SYMBOL stuck on` or `SYMBOL stuck off`, of a BOOL input of the PLC:
/// the name of a malfunction that every plant has without describing it.
bool is_ordinary_malfunction(std::string_view name, const PlantNames& names, const PlantModel& plant) {
  for (const std::string_view ending : {" stuck", " slow"}) {
    const std::string_view path = before(name, ending);
    if (!path.empty() && names.unit(path, {})) return true;
  }
  for (const std::string_view ending : {" stuck on", " stuck off"}) {
    const std::string_view of = before(name, ending);
    const auto symbol = of.empty() ? std::nullopt : names.symbol(of);
    if (symbol && symbol->type == tables::DataType::boolean &&
        plant.symbols[symbol->index].direction == tables::Direction::event) {
      return true;
    }
  }
  return false;
}

using description::FaultKind;
using description::Pointer;
using description::ticked;

class MalfunctionResolver {
 public:
  MalfunctionResolver(PlantModel& plant, description::Faults& faults)
      : plant_(plant), faults_(faults), names_(plant, faults), given_(plant.description->malfunctions) {}

  void run() {
    for (std::uint32_t i = 0; i < given_.size(); ++i) declare(i);
    for (std::uint32_t i = 0; i < given_.size(); ++i) {
      Malfunction& malfunction = plant_.malfunctions.emplace_back();
      malfunction.name = given_[i].name;
      resolve(given_[i], Pointer("/malfunctions") / std::size_t{i}, malfunction);
    }
  }

 private:
  void declare(std::uint32_t index) {
    const std::string& name = given_[index].name;
    const Pointer here = Pointer("/malfunctions") / std::size_t{index} / "name";
    if (name.empty()) return;
    if (!by_name_.try_emplace(name, index).second) {
      faults_.add(here, ticked(name) + " already names another malfunction; choose another name");
    } else if (is_ordinary_malfunction(name, names_, plant_)) {
      faults_.add(here, ticked(name) + " is an ordinary malfunction, which every plant has; choose another name");
    }
  }

  void resolve(const description::GivenMalfunction& given, const Pointer& here, Malfunction& malfunction) {
    resolve_effects(given, here, malfunction);
    malfunction.condition = condition(given.when, here / (given.during ? "while" : "when"));
    malfunction.during = given.during;
    malfunction.chance = given.chance;
    malfunction.lasts = given.lasts;
    if (given.becomes) resolve_becomes(*given.becomes, here / "becomes", malfunction);
  }

  /// Devices that the malfunction names are those of the effects that name none.
  void resolve_effects(const description::GivenMalfunction& given, const Pointer& here, Malfunction& malfunction) {
    const GivenDevices named{given.one.of, here / "of", given.one.of_is_list};
    if (given.effects.empty()) {
      if (given.one.kinds.size() != 1) return;
      malfunction.effects.push_back(resolve_effect(plant_, names_, given.one, named, here, faults_));
      return;
    }
    bool uses = given.one.of.empty();
    for (std::size_t i = 0; i < given.effects.size(); ++i) {
      const description::GivenEffect& effect = given.effects[i];
      const Pointer at = here / "effects" / i;
      if (effect.kinds.size() != 1) continue;
      uses = uses || (names_devices(effect.kinds.front()) && effect.of.empty());
      const GivenDevices own{effect.of, at / "of", effect.of_is_list};
      malfunction.effects.push_back(
          resolve_effect(plant_, names_, effect, effect.of.empty() ? named : own, at, faults_));
    }
    if (!uses) faults_.add(here / "of", "no effect of this malfunction needs `of`; remove it");
  }

  std::optional<condition::Tree> condition(const std::string& text, const Pointer& here) {
    if (text.empty()) return std::nullopt;
    auto resolved = condition::parse_and_resolve(text, names_);
    if (auto* tree = std::get_if<condition::Tree>(&resolved)) return std::move(*tree);
    auto& fault = std::get<condition::Fault>(resolved);
    faults_.add(here, std::move(fault.message), FaultKind::condition, fault.index.offset);
    return std::nullopt;
  }

  void resolve_becomes(const description::GivenBecomes& given, const Pointer& here, Malfunction& malfunction) {
    malfunction.after = given.after;
    malfunction.unless = condition(given.unless, here / "unless");
    if (given.start.empty()) return;
    const auto found = by_name_.find(given.start);
    if (found != by_name_.end()) {
      malfunction.next = found->second;
      return;
    }
    const auto nearest =
        faults_.nearest(given.start, given_.size(), [&](std::size_t i) -> std::string_view { return given_[i].name; });
    faults_.add(here / "start", description::missing("malfunction " + ticked(given.start), nearest),
                FaultKind::unknown_name);
  }

  PlantModel& plant_;
  description::Faults& faults_;
  PlantNames names_;
  const std::vector<description::GivenMalfunction>& given_;
  text::ByName<std::uint32_t> by_name_;
};

}  // namespace

void resolve_malfunctions(PlantModel& plant, description::Faults& faults) {
  if (plant.description->malfunctions.empty()) return;
  MalfunctionResolver(plant, faults).run();
}

}  // namespace symplant::model
