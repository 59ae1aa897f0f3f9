// Resolves the malfunctions of the description.
#include "elements/malfunction/resolve.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include "model/plant_names.hpp"
#include "symplant/condition/compare.hpp"
#include "symplant/condition/resolve.hpp"
#include "symplant/condition/value.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"

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
using tables::MalfunctionKind;

class MalfunctionResolver {
 public:
  MalfunctionResolver(PlantModel& plant, description::Faults& faults)
      : plant_(plant), faults_(faults), names_(plant, faults), given_(plant.description->malfunctions) {}

  void run() {
    for (std::uint32_t i = 0; i < given_.size(); ++i) declare(i);
    for (std::uint32_t i = 0; i < given_.size(); ++i) {
      Malfunction& malfunction = plant_.malfunctions.emplace_back();
      malfunction.name = given_[i].name;
      if (given_[i].kinds.size() == 1) resolve(given_[i], Pointer("/malfunctions") / std::size_t{i}, malfunction);
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
    malfunction.kind = given.kinds.front();
    resolve_units(given, here, malfunction);
    malfunction.factor = given.factor;
    resolve_forces(given, here / "force", malfunction);
    if (malfunction.kind == MalfunctionKind::flicker) resolve_flicker(given, here / "flicker", malfunction);
    if (malfunction.kind == MalfunctionKind::lose) malfunction.subject = controller(given.lose, here / "lose");
    malfunction.condition = condition(given.when, here / "when");
    malfunction.chance = given.chance;
    malfunction.lasts = given.lasts;
    if (given.becomes) resolve_becomes(*given.becomes, here / "becomes", malfunction);
  }

  void resolve_units(const description::GivenMalfunction& given, const Pointer& here, Malfunction& malfunction) {
    const bool of_units = malfunction.kind == MalfunctionKind::slower || malfunction.kind == MalfunctionKind::stuck;
    if (!of_units) {
      if (!given.of.empty()) faults_.add(here / "of", "`of` is only for `slower` and `stuck`; remove it");
      return;
    }
    if (given.of.empty()) {
      faults_.add(here, "this malfunction names no device; add `of`");
      return;
    }
    for (std::size_t i = 0; i < given.of.size(); ++i) {
      const Pointer at = given.of_is_list ? here / "of" / i : here / "of";
      add_units(given.of[i], units_of(given.of[i], at), given.state, here / "stuck", malfunction);
    }
    auto& units = malfunction.units;
    std::sort(units.begin(), units.end(), [](const auto& a, const auto& b) { return a.unit < b.unit; });
    units.erase(std::unique(units.begin(), units.end(), [](const auto& a, const auto& b) { return a.unit == b.unit; }),
                units.end());
  }

  static bool is_pattern(std::string_view name) { return name.find_first_of("*?") != std::string_view::npos; }

  /// The units of a device, or of those that a pattern matches.
  std::vector<std::uint32_t> units_of(const std::string& name, const Pointer& here) {
    std::vector<std::uint32_t> units;
    if (is_pattern(name)) {
      for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
        const Unit& unit = plant_.units[u];
        if (text::matches_pattern(unit.path, name) || text::matches_pattern(unit.device_path(), name)) {
          units.push_back(u);
        }
      }
      if (units.empty()) faults_.warn(here, ticked(name) + " matches no device", FaultKind::matches_nothing);
      return units;
    }
    units = names_.facets(name);
    if (const auto unit = names_.unit(name, {})) units.push_back(*unit);
    if (units.empty()) {
      faults_.add(here, description::missing("device " + ticked(name), names_.nearest_device(name, {})),
                  FaultKind::unknown_name);
    }
    return units;
  }

  /// Adds units with a state; those that lack it are left out, unless all do.
  void add_units(const std::string& name, const std::vector<std::uint32_t>& units, const std::string& state,
                 const Pointer& here, Malfunction& malfunction) {
    std::vector<std::uint32_t> lacking;
    for (const std::uint32_t unit : units) {
      const auto found = state.empty() ? std::optional(tables::kNoState) : names_.state(unit, state);
      if (found) {
        malfunction.units.push_back({unit, *found});
      } else {
        lacking.push_back(unit);
      }
    }
    if (lacking.empty()) return;
    const std::string& first = std::string(plant_.units[lacking.front()].path);
    if (lacking.size() == units.size()) {
      std::string why = units.size() == 1 ? names_.why_no_state(lacking.front(), state) : std::string();
      if (why.empty()) {
        why = description::missing("state " + ticked(state) + " of " + ticked(units.size() == 1 ? first : name),
                                   names_.nearest_state(lacking.front(), state));
      }
      faults_.add(here, std::move(why), FaultKind::unknown_name);
    } else {
      faults_.warn(here,
                   std::to_string(lacking.size()) + " of the " + std::to_string(units.size()) + " devices that " +
                       ticked(name) + " names have no state " + ticked(state) +
                       "; the malfunction leaves them out, the first is " + ticked(first),
                   FaultKind::left_out);
    }
  }

  std::uint32_t symbol(const std::string& name, const Pointer& here) {
    if (const auto found = names_.symbol(name)) return found->index;
    faults_.add(here, description::missing("symbol " + ticked(name), names_.nearest_symbol(name)),
                FaultKind::unknown_name);
    return kNone;
  }

  std::optional<std::uint64_t> value(std::uint32_t symbol, const description::GivenForcedValue& given,
                                     const Pointer& here) {
    const tables::DataType type = plant_.symbols[symbol].type;
    if ((type == tables::DataType::boolean) != given.bit.has_value()) {
      faults_.add(here, "expected " + std::string(given.bit ? "a number" : "true or false") + " for a " +
                            std::string(condition::type_name(type)) + ", but found " + given.shown);
      return std::nullopt;
    }
    if (given.bit) return *given.bit ? 1 : 0;
    auto read = condition::read_number(type, given.number, given.shown);
    if (const auto* number = std::get_if<std::uint64_t>(&read)) return *number;
    faults_.add(here, std::move(std::get<std::string>(read)));
    return std::nullopt;
  }

  void resolve_forces(const description::GivenMalfunction& given, const Pointer& here, Malfunction& malfunction) {
    if (malfunction.kind != MalfunctionKind::force) return;
    if (given.force.empty()) faults_.add(here, "this malfunction gives no symbol a value; name at least one");
    std::map<std::uint32_t, std::uint32_t> by_leader;
    for (const auto& [name, given_value] : given.force) {
      const Pointer at = here / std::string_view(name);
      const std::uint32_t found = symbol(name, at);
      if (found == kNone) continue;
      const auto number = value(found, given_value, at);
      if (!number) continue;
      const auto [other, is_new] = by_leader.try_emplace(leader(found), found);
      if (!is_new) {
        faults_.add(at, ticked(name) + " and " + ticked(plant_.symbols[other->second].name()) +
                            " are on one address; name one of them");
      }
      malfunction.forces.push_back({found, *number});
    }
    std::sort(malfunction.forces.begin(), malfunction.forces.end(),
              [](const auto& a, const auto& b) { return a.symbol < b.symbol; });
  }

  std::uint32_t leader(std::uint32_t symbol) const {
    return plant_.symbols[symbol].leader == kNone ? symbol : plant_.symbols[symbol].leader;
  }

  void resolve_flicker(const description::GivenMalfunction& given, const Pointer& here, Malfunction& malfunction) {
    const std::uint32_t found = symbol(given.flicker.symbol, here / "symbol");
    if (found != kNone && plant_.symbols[found].type != tables::DataType::boolean) {
      faults_.add(here / "symbol", ticked(given.flicker.symbol) + " is a number; only BOOL symbols flicker");
    }
    malfunction.subject = found;
    malfunction.every = given.flicker.every;
    malfunction.shows = given.flicker.shows;
  }

  std::uint32_t controller(const std::string& name, const Pointer& here) {
    const std::vector<std::string>& all = plant_.controllers;
    if (name.empty()) {
      if (all.size() == 1) return 0;
      faults_.add(here, "the plant has several controllers; name one of them");
      return kNone;
    }
    for (std::uint32_t c = 0; c < all.size(); ++c) {
      if (text::equal_ignoring_case(all[c], name)) return c;
    }
    if (all.size() == 1 && all[0].empty()) {
      faults_.add(here,
                  "controller " + ticked(name) + " not found, because this plant's only controller has no name; " +
                      "write `true`, or add `controller` to its list in `symbols`",
                  FaultKind::unknown_name);
    } else {
      const auto nearest = faults_.nearest(name, all.size(), [&](std::size_t c) -> std::string_view { return all[c]; });
      faults_.add(here, description::missing("controller " + ticked(name), nearest), FaultKind::unknown_name);
    }
    return kNone;
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
