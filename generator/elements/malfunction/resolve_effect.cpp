// Resolves what a malfunction does: its devices and tracks, symbols, parameters, controller.
#include "elements/malfunction/resolve_effect.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include "symplant/condition/compare.hpp"
#include "symplant/condition/value.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

using description::FaultKind;
using description::Pointer;
using description::ticked;
using tables::MalfunctionKind;

/// Sorts rows by a member, and keeps the first of several with an equal one.
template <class Row, class Member>
void sort_once(std::vector<Row>& rows, Member member) {
  const auto key = [member](const Row& row) { return std::invoke(member, row); };
  std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) { return key(a) < key(b); });
  rows.erase(std::unique(rows.begin(), rows.end(), [&](const Row& a, const Row& b) { return key(a) == key(b); }),
             rows.end());
}

class EffectResolver {
 public:
  EffectResolver(const PlantModel& plant, const PlantNames& names, const description::GivenEffect& given,
                 const Pointer& here, description::Faults& faults)
      : plant_(plant), names_(names), given_(given), here_(here), faults_(faults) {}

  Effect run(const GivenDevices& of) {
    effect_.kind = given_.kinds.front();
    if (!names_devices(effect_.kind) && !given_.of.empty()) {
      faults_.add(here_ / "of", "`of` is only for `slower` and `stuck`; remove it");
    }
    effect_.factor = given_.factor;
    effect_.distort = given_.distort;
    switch (effect_.kind) {
      case MalfunctionKind::slower:
      case MalfunctionKind::stuck:
        resolve_devices(of);
        break;
      case MalfunctionKind::force:
        resolve_forces(here_ / "force");
        break;
      case MalfunctionKind::flicker:
        resolve_flicker(here_ / "flicker");
        break;
      case MalfunctionKind::lose:
        effect_.subject = controller(given_.lose, here_ / "lose");
        break;
      case MalfunctionKind::set:
        resolve_sets(here_ / "set");
        break;
      case MalfunctionKind::distort:
        effect_.subject = signal(given_.distort.symbol, here_ / "distort" / "symbol");
        break;
    }
    return std::move(effect_);
  }

 private:
  void resolve_devices(const GivenDevices& of) {
    if (of.names.empty()) {
      faults_.add(here_, "this malfunction names no device; add `of`");
      return;
    }
    for (std::size_t i = 0; i < of.names.size(); ++i) {
      const Pointer at = of.is_list ? of.here / i : of.here;
      const Found found = find(of.names[i], at);
      add_units(of.names[i], found.units);
      add_tracks(of.names[i], found.tracks);
    }
    sort_once(effect_.units, &tables::MalfunctionUnit::unit);
    sort_once(effect_.tracks, std::identity{});
  }

  struct Found {
    std::vector<std::uint32_t> units;
    std::vector<std::uint32_t> tracks;
  };

  /// The units of a device, or a track, or all that a pattern matches.
  Found find(const std::string& name, const Pointer& here) {
    Found found;
    const auto& tracks = plant_.material.tracks;
    if (text::is_pattern(name)) {
      for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
        const Unit& unit = plant_.units[u];
        if (text::matches_pattern(unit.path, name) || text::matches_pattern(unit.device_path(), name)) {
          found.units.push_back(u);
        }
      }
      for (std::uint32_t t = 0; t < tracks.size(); ++t) {
        if (text::matches_pattern(tracks[t].name, name)) found.tracks.push_back(t);
      }
      if (found.units.empty() && found.tracks.empty()) {
        faults_.warn(here, ticked(name) + " matches no device and no track", FaultKind::matches_nothing);
      }
      return found;
    }
    found.units = names_.facets(name);
    if (const auto unit = names_.unit(name, {})) found.units.push_back(*unit);
    const auto location = names_.location(name);
    if (found.units.empty() && location && *location < tracks.size()) found.tracks.push_back(*location);
    if (found.units.empty() && found.tracks.empty()) missing_device(name, here);
    return found;
  }

  void missing_device(const std::string& name, const Pointer& here) {
    const auto& tracks = plant_.material.tracks;
    std::string nearest = names_.nearest_device(name, {});
    if (nearest.empty()) {
      nearest = faults_.nearest(name, tracks.size(), [&](std::size_t t) -> std::string_view { return tracks[t].name; });
    }
    faults_.add(here, description::missing((tracks.empty() ? "device " : "device or track ") + ticked(name), nearest),
                FaultKind::unknown_name);
  }

  /// Adds units with a state; those that lack it are left out, unless all do.
  void add_units(const std::string& name, const std::vector<std::uint32_t>& units) {
    const std::string& state = given_.state;
    std::vector<std::uint32_t> lacking;
    for (const std::uint32_t unit : units) {
      const auto found = state.empty() ? std::optional(tables::kNoState) : names_.state(unit, state);
      if (found) {
        effect_.units.push_back({unit, *found});
      } else {
        lacking.push_back(unit);
      }
    }
    if (lacking.empty()) return;
    const Pointer here = here_ / "stuck";
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

  /// Tracks have no state: those of a pattern are left out.
  void add_tracks(const std::string& name, const std::vector<std::uint32_t>& tracks) {
    if (given_.state.empty()) {
      effect_.tracks.insert(effect_.tracks.end(), tracks.begin(), tracks.end());
    } else if (!text::is_pattern(name) && !tracks.empty()) {
      faults_.add(here_ / "stuck", ticked(name) + " is a track, which has no states; write `true`");
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

  void resolve_forces(const Pointer& here) {
    if (given_.force.empty()) faults_.add(here, "this malfunction gives no symbol a value; name at least one");
    std::map<std::uint32_t, std::uint32_t> by_leader;
    for (const auto& [name, given_value] : given_.force) {
      const Pointer at = here / std::string_view(name);
      const std::uint32_t found = symbol(name, at);
      if (found == kNone) continue;
      if (given_value.holds) check_hold(found, at);
      const auto number = given_value.holds ? std::optional<std::uint64_t>(0) : value(found, given_value, at);
      if (!number) continue;
      const auto [other, is_new] = by_leader.try_emplace(leader(found), found);
      if (!is_new) {
        faults_.add(at, ticked(name) + " and " + ticked(plant_.symbols[other->second].name()) +
                            " are on one address; name one of them");
      }
      effect_.forces.push_back({found, *number, given_value.holds});
    }
    std::sort(effect_.forces.begin(), effect_.forces.end(),
              [](const auto& a, const auto& b) { return a.symbol < b.symbol; });
  }

  std::uint32_t leader(std::uint32_t symbol) const {
    return plant_.symbols[symbol].leader == kNone ? symbol : plant_.symbols[symbol].leader;
  }

  void resolve_flicker(const Pointer& here) {
    const std::uint32_t found = symbol(given_.flicker.symbol, here / "symbol");
    if (found != kNone && plant_.symbols[found].type != tables::DataType::boolean) {
      faults_.add(here / "symbol", ticked(given_.flicker.symbol) + " is a number; only BOOL symbols flicker");
    }
    effect_.subject = found;
    effect_.every = given_.flicker.every;
    effect_.shows = given_.flicker.shows;
  }

  void check_hold(std::uint32_t symbol, const Pointer& here) {
    if (plant_.symbols[symbol].direction == tables::Direction::event) return;
    faults_.add(here, ticked(plant_.symbols[symbol].name()) +
                          " is an operation; only events hold what they show, so write the value that it has");
  }

  void resolve_sets(const Pointer& here) {
    if (given_.set.empty()) faults_.add(here, "this malfunction sets no parameter; name at least one");
    std::map<std::uint32_t, std::string_view> names_of;
    for (const auto& [name, number] : given_.set) {
      const Pointer at = here / std::string_view(name);
      const auto found = names_.value(name);
      if (!found) {
        faults_.add(at, description::missing("parameter " + ticked(name), names_.nearest_value(name)),
                    FaultKind::unknown_name);
        continue;
      }
      const std::uint32_t value = value_of(found->output);
      if (plant_.values[value].row.kind != tables::ValueKind::parameter) {
        faults_.add(at, ticked(name) + " is computed; a malfunction sets only parameters, which have no formula");
      }
      const auto [known, is_new] = names_of.try_emplace(value, name);
      if (!is_new) faults_.add(at, ticked(name) + " and " + ticked(known->second) + " are one parameter; remove one");
      effect_.sets.push_back({value, number});
    }
    sort_once(effect_.sets, &tables::MalfunctionSet::value);
  }

  /// O(log values).
  std::uint32_t value_of(std::uint32_t output) const {
    const auto after = std::upper_bound(plant_.values.begin(), plant_.values.end(), output,
                                        [](std::uint32_t of, const Value& value) { return of < value.row.output; });
    return static_cast<std::uint32_t>(after - plant_.values.begin()) - 1;
  }

  /// The signal that writes a symbol.
  std::uint32_t signal(const std::string& name, const Pointer& here) {
    const std::uint32_t found = symbol(name, here);
    if (found == kNone) return kNone;
    for (std::uint32_t s = 0; s < plant_.signals.size(); ++s) {
      if (plant_.signals[s].row.symbol == found) return s;
    }
    faults_.add(here, ticked(name) + " has no entry in `signals`; only signals can be out of adjustment");
    return kNone;
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

  const PlantModel& plant_;
  const PlantNames& names_;
  const description::GivenEffect& given_;
  const Pointer& here_;
  description::Faults& faults_;
  Effect effect_;
};

}  // namespace

Effect resolve_effect(const PlantModel& plant, const PlantNames& names, const description::GivenEffect& given,
                      const GivenDevices& of, const Pointer& here, description::Faults& faults) {
  return EffectResolver(plant, names, given, here, faults).run(of);
}

}  // namespace symplant::model
