// The malfunctions of a plant.json.
#include "property/files/malfunctions_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace symplant::property::files {
namespace {

using description::GivenEffect;
using description::GivenMalfunction;
using nlohmann::json;
using tables::MalfunctionKind;

class MalfunctionJson {
 public:
  MalfunctionJson(const model::PlantModel& plant, Sayer& sayer, Counts& counts)
      : plant_(plant), sayer_(sayer), counts_(counts) {}

  json write(const GivenMalfunction& given) {
    json said = {{"name", sayer_.name(given.name)}};
    effect(said, given.one);
    for (const GivenEffect& each : given.effects) {
      json one = json::object();
      effect(one, each);
      said["effects"].push_back(std::move(one));
    }
    count(Seen::malfunctions_of_several_effects, !given.effects.empty());
    if (!given.when.empty()) said[given.during ? "while" : "when"] = sayer_.condition(given.when);
    count(Seen::malfunctions_while, given.during);
    if (given.chance) said["chance"] = sayer_.duration(*given.chance);
    if (given.lasts) said["lasts"] = sayer_.duration(*given.lasts);
    count(Seen::malfunctions_when, !given.when.empty() && !given.during);
    count(Seen::malfunctions_by_chance, given.chance.has_value());
    count(Seen::malfunctions_that_last, given.lasts.has_value());
    if (!given.becomes) return said;
    json& becomes = said["becomes"];
    becomes = {{"after", sayer_.time(given.becomes->after)}, {"start", sayer_.name(given.becomes->start)}};
    if (!given.becomes->unless.empty()) becomes["unless"] = sayer_.condition(given.becomes->unless);
    count(given.becomes->unless.empty() ? Seen::malfunctions_that_become : Seen::malfunctions_unless);
    return said;
  }

 private:
  void count(Seen what, bool seen = true) { counts_[what] += seen ? 1 : 0; }

  void effect(json& said, const GivenEffect& given) {
    if (!given.of.empty()) said["of"] = devices(given);
    if (given.kinds.empty()) return;
    switch (given.kinds.front()) {
      case MalfunctionKind::slower:
        said["slower"] = given.factor / 1000.0;
        return count(Seen::slower);
      case MalfunctionKind::stuck:
        said["stuck"] = given.state.empty() ? json(true) : json(sayer_.name(given.state));
        return count(given.state.empty() ? Seen::stuck : Seen::stuck_in_a_state);
      case MalfunctionKind::force:
        for (const auto& [symbol, value] : given.force) said["force"][sayer_.name(symbol)] = forced(value);
        return count(Seen::malfunctions_that_force);
      case MalfunctionKind::flicker:
        said["flicker"] = {{"symbol", sayer_.name(given.flicker.symbol)},
                           {"every", sayer_.duration(*given.flicker.every)},
                           {"for", sayer_.time(given.flicker.shows)}};
        return count(Seen::flicker);
      case MalfunctionKind::lose:
        said["lose"] = given.lose.empty() ? json(true) : json(sayer_.name(given.lose));
        return count(Seen::lose);
      case MalfunctionKind::set:
        for (const auto& [parameter, number] : given.set) said["set"][parameter] = number;
        return count(Seen::malfunctions_that_set);
      case MalfunctionKind::distort:
        said["distort"] = {{"symbol", sayer_.name(given.distort.symbol)}};
        if (given.distort.gain != 1) said["distort"]["gain"] = given.distort.gain;
        if (given.distort.offset != 0) said["distort"]["offset"] = given.distort.offset;
        if (given.distort.drift != 0) said["distort"]["drift"] = given.distort.drift;
        return count(Seen::malfunctions_that_distort);
    }
  }

  json forced(const description::GivenForcedValue& value) {
    if (value.bit) return *value.bit;
    count(Seen::held_events, value.holds);
    if (value.holds) return value.number;
    if (value.number == "nan" || value.number == "inf" || sayer_.dice.percent(10)) return value.number;
    return json::parse(value.number);
  }

  /// The devices that the pattern names; empty if only their names with facets match, or if it names tracks, too.
  std::vector<std::string> named(const std::string& pattern) const {
    std::vector<std::string> devices;
    for (const model::Track& track : plant_.material.tracks) {
      if (fits(track.name, pattern)) return {};
    }
    for (const model::Unit& unit : plant_.units) {
      const std::string device(unit.device_path());
      const bool is_whole = device == unit.path;
      if (!is_whole && fits(std::string(unit.path), pattern) && !fits(device, pattern)) return {};
      if (fits(device, pattern)) devices.push_back(device);
    }
    return devices;
  }

  /// A pattern that names the same devices; empty if a few tries find none.
  std::string pattern_of(const std::vector<std::string>& devices) {
    const std::set<std::string> wanted(devices.begin(), devices.end());
    for (int tries = 0; tries < 4; ++tries) {
      std::string pattern = random_pattern(sayer_.dice, sayer_.dice.pick(devices));
      const auto found = named(pattern);
      if (reference::is_pattern(pattern) && std::set<std::string>(found.begin(), found.end()) == wanted) return pattern;
    }
    return {};
  }

  /// In a state, devices that a pattern names may lack it.
  json devices(const GivenEffect& given) {
    std::vector<std::string> said;
    for (const std::string& of : given.of) {
      const bool is_pattern = reference::is_pattern(of);
      const auto devices = is_pattern ? named(of) : std::vector{of};
      if (!given.state.empty() || devices.empty() || sayer_.dice.percent(40)) {
        said.push_back(sayer_.name(of));
      } else if (is_pattern) {
        for (const std::string& device : devices) said.push_back(sayer_.name(device));
        count(Seen::patterns_as_devices);
      } else if (std::string pattern = pattern_of(devices); !pattern.empty()) {
        said.push_back(std::move(pattern));
        count(Seen::devices_as_patterns);
      } else {
        said.push_back(sayer_.name(of));
      }
    }
    if (said.size() == 1 && sayer_.dice.percent(70)) return said.front();
    return said;
  }

  const model::PlantModel& plant_;
  Sayer& sayer_;
  Counts& counts_;
};

}  // namespace

void make_malfunctions_sayable(PlantText& plant) {
  for (GivenMalfunction& given : plant.description.malfunctions) {
    const auto complete = [&plant](GivenEffect& effect) {
      if (effect.kinds.empty()) return;
      const bool loses = effect.kinds.front() == MalfunctionKind::lose;
      if (loses && effect.lose.empty() && plant.two_lists()) effect.lose = plant.second_controller;
      const description::GivenDistort& distort = effect.distort;
      const bool distorts = distort.gain != 1 || distort.offset != 0 || distort.drift != 0;
      if (effect.kinds.front() == MalfunctionKind::distort && !distorts) effect.distort.offset = 1;
    };
    complete(given.one);
    for (GivenEffect& effect : given.effects) complete(effect);
  }
}

json malfunctions_json(const description::Description& description, const model::PlantModel& plant, Sayer& sayer,
                       Counts& counts) {
  json said = json::array();
  for (const GivenMalfunction& given : description.malfunctions) {
    said.push_back(MalfunctionJson(plant, sayer, counts).write(given));
  }
  return said;
}

}  // namespace symplant::property::files
