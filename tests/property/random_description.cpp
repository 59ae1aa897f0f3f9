// A random valid description of a random plan, with every feature of descriptions.
#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "property/behaviours.hpp"
#include "property/random_unit.hpp"

namespace symplant::property {
namespace {

using description::DeviceDescription;
using description::GivenTransition;
using tables::Actuation;

class DeviceWriter {
 public:
  DeviceWriter(Dice& dice, const PlannedPlant& plan, const PlannedUnit& unit,
               const std::vector<description::GivenFollow>& follow)
      : dice_(dice), plan_(plan), unit_(unit), follow_(follow), states_(unit.states()) {
    device_.path = unit.path;
    device_.states = unit.added;
  }

  DeviceDescription write() {
    if (dice_.percent(55)) device_.actuation = static_cast<Actuation>(dice_.below(4));
    if (dice_.percent(25)) device_.initial = dice_.pick(states_);
    if (device_.actuation == Actuation::spring && dice_.percent(50)) device_.rest = dice_.pick(states_);
    if (device_.actuation == Actuation::held && dice_.percent(40)) device_.overrun = random_overrun(dice_);
    const bool numbered = std::any_of(states_.begin(), states_.end(), [](const std::string& state) {
      return state.back() >= '0' && state.back() <= '9';
    });
    if (numbered && dice_.percent(25)) device_.sequence = random_sequence(dice_);
    device_.only = dice_.percent(8);
    for (const std::string& command : unit_.commands) command_transition(command);
    if (states_.size() > 1) {
      for (std::size_t i = dice_.below(dice_.percent(20) ? 7 : 4); i > 0; --i) transition();
      if (!plan_.plain && dice_.percent(14)) chances();
      for (const description::GivenFollow& given : follow_) loop_with(given);
    }
    outputs();
    disables();
    if (dice_.percent(10)) device_.type = "Kind";
    if (unit_.behaves) behaviour();
    return std::move(device_);
  }

 private:
  /// Adds a transition unless it exists already.
  void add(GivenTransition given) {
    if (given.from == given.to) return;
    const std::string on = given.automatic ? "*" : given.on.empty() ? given.to : given.on;
    for (const std::string& from : states_) {
      if (from == given.to || (given.from != "*" && given.from != from)) continue;
      if (taken_.contains({from, given.to, on, given.when})) return;
    }
    for (const std::string& from : states_) taken_.insert({from, given.to, on, given.when});
    device_.transitions.push_back(std::move(given));
  }

  GivenTransition route() {
    GivenTransition given;
    given.to = dice_.pick(states_);
    do {
      given.from = dice_.percent(20) ? "*" : dice_.pick(states_);
    } while (given.from == given.to);
    return given;
  }

  void times_and_cause(GivenTransition& given, unsigned after, unsigned when) {
    if (dice_.percent(after)) given.after = random_duration(dice_);
    if (dice_.percent(55)) given.takes = random_duration(dice_);
    if (dice_.percent(when)) given.when = random_condition(dice_, plan_, unit_);
    if (!plan_.plain) while_and_weight(given);
    given.once = !given.automatic && device_.actuation == Actuation::latched && dice_.percent(25);
  }

  void while_and_weight(GivenTransition& given) {
    const bool turns = device_.actuation && device_.actuation != Actuation::latched;
    if (dice_.percent(turns ? 45 : 25)) given.during = random_condition(dice_, plan_, unit_);
    if (given.automatic && dice_.percent(35)) given.numbers.weight = random_weight();
  }

  std::uint32_t random_weight() {
    if (dice_.percent(5)) return 1'000'000;
    return 1 + static_cast<std::uint32_t>(dice_.below(5));
  }

  /// Automatic transitions that are ready together.
  void chances() {
    const GivenTransition first = route();
    const description::Duration after = random_duration(dice_);
    for (const std::string& to : states_) {
      if (to == first.from || !dice_.percent(70)) continue;
      GivenTransition given = first;
      given.to = to;
      given.automatic = true;
      given.after = after;
      if (dice_.percent(40)) given.takes = random_duration(dice_);
      if (dice_.percent(90)) given.numbers.weight = random_weight();
      add(std::move(given));
    }
  }

  /// Makes an instantaneous loop of the unit and a symbol that follows one of its states.
  void loop_with(const description::GivenFollow& follow) {
    if (follow.symbol.ends_with('?')) return;
    for (const std::string& state : states_) {
      if (follow.condition != unit_.path + "." + state || !dice_.percent(30)) continue;
      const std::string& other = dice_.pick(states_);
      add({state, other, "", "'" + follow.symbol + "'", true});
      add({other, state, "", "not '" + follow.symbol + "'", true});
    }
  }

  void command_transition(const std::string& command) {
    if (states_.size() < 2) return;
    GivenTransition given = route();
    given.on = command;
    times_and_cause(given, 15, 25);
    add(std::move(given));
  }

  void transition() {
    GivenTransition given = route();
    const auto operations = unit_.operations();
    const bool own = std::find(operations.begin(), operations.end(), given.to) != operations.end();
    const bool springs_own = device_.rest == given.to && !own;
    given.automatic = dice_.percent(40) || (operations.empty() && !springs_own);
    if (given.automatic) {
      times_and_cause(given, 85, 50);
    } else if (springs_own && (operations.empty() || dice_.percent(70))) {
      given.takes = random_duration(dice_);
      if (!plan_.plain && dice_.percent(45)) given.during = random_condition(dice_, plan_, unit_);
    } else {
      if (!own || dice_.percent(30)) given.on = dice_.pick(operations);
      times_and_cause(given, 20, 30);
    }
    add(std::move(given));
  }

  void outputs() {
    const auto events = unit_.events();
    if (events.empty() || (unit_.signals.empty() && !dice_.percent(12))) return;
    std::set<std::string> reported;
    for (std::size_t i = 1 + dice_.below(3); i > 0; --i) {
      description::GivenOutputs given;
      given.state = dice_.pick(states_);
      if (!reported.insert(given.state).second) continue;
      const auto some = [&](std::vector<std::pair<std::string, bool>>& side) {
        for (std::size_t k = dice_.below(3); k > 0; --k) {
          const bool signal = !unit_.signals.empty() && dice_.percent(75);
          const std::string& event = signal ? dice_.pick(unit_.signals) : dice_.pick(events);
          side.emplace_back(event, dice_.percent(60));
        }
      };
      some(given.enter);
      some(given.leave);
      if (!given.enter.empty() || !given.leave.empty()) device_.outputs.push_back(std::move(given));
    }
  }

  void disables() {
    if (plan_.units.size() < 2 || !dice_.percent(22)) return;
    std::set<std::string> reported;
    for (std::size_t i = 1 + dice_.below(2); i > 0; --i) {
      description::GivenDisables given;
      given.state = dice_.pick(states_);
      if (!reported.insert(given.state).second) continue;
      std::set<std::string> others;
      for (std::size_t k = 1 + dice_.below(2); k > 0; --k) others.insert(dice_.pick(plan_.units).path);
      others.erase(unit_.path);
      given.devices.assign(others.begin(), others.end());
      if (!given.devices.empty()) device_.disables.push_back(std::move(given));
    }
  }

  void behaviour() {
    // A separate name for each unit: units with the same behavior must have the same structure.
    device_.behaviour = dice_.pick(behaviour_names()) + "_" + std::to_string(&unit_ - plan_.units.data());
    for (std::size_t i = 1 + dice_.below(2); i > 0; --i) {
      device_.inputs.emplace_back("in" + std::to_string(i), random_condition(dice_, plan_, unit_));
    }
  }

  Dice& dice_;
  const PlannedPlant& plan_;
  const PlannedUnit& unit_;
  const std::vector<description::GivenFollow>& follow_;
  std::vector<std::string> states_;
  DeviceDescription device_;
  std::set<std::tuple<std::string, std::string, std::string, std::string>> taken_;  ///< from, to, on, when
};

description::GivenRequirement random_requirement(Dice& dice, const PlannedPlant& plan, std::size_t number) {
  description::GivenRequirement given;
  given.name = "r" + std::to_string(number);
  const PlannedUnit& own = dice.pick(plan.units);
  if (dice.percent(45)) {
    given.never = random_condition(dice, plan, own);
    return given;
  }
  given.after = random_condition(dice, plan, own);
  given.expect = random_condition(dice, plan, own);
  given.within = random_time(dice);
  if (dice.percent(30)) given.earliest = std::min(given.within, random_time(dice));
  return given;
}

/// A pattern that matches the name, and perhaps others.
std::string as_pattern(Dice& dice, std::string name) {
  if (dice.percent(50)) {
    name[dice.below(name.size())] = '?';
  } else {
    const std::size_t at = dice.below(name.size());
    name.replace(at, 1 + dice.below(2), "*");
  }
  return name;
}

/// Conditions of followers name only earlier ones: they may not follow each other in a circle.
std::vector<description::GivenFollow> random_follow(Dice& dice, const PlannedPlant& plan) {
  std::vector<description::GivenFollow> follow;
  PlannedPlant earlier = plan;
  earlier.followers.clear();
  for (const std::string& name : plan.followers) {
    const PlannedUnit& own = dice.pick(plan.units);
    std::string condition = random_condition(dice, earlier, own);
    if (!earlier.followers.empty() && dice.percent(30)) {
      condition = dice.percent(30) ? "not '" : "'";
      condition += dice.pick(earlier.followers) + "'";
    } else if (dice.percent(30)) {
      condition = own.path + "." + dice.pick(own.states());
    }
    follow.push_back({dice.percent(15) ? name.substr(0, name.size() - 1) + "?" : name, std::move(condition)});
    earlier.followers.push_back(name);
  }
  return follow;
}

}  // namespace

std::vector<std::string> random_inverted(Dice& dice, const std::vector<Row>& rows) {
  std::vector<std::string> inverted;
  if (dice.percent(50)) return inverted;
  const unsigned chance = dice.percent(50) ? 12 : 45;
  for (const Row& row : rows) {
    if (row.type != "BOOL" || !dice.percent(chance)) continue;
    inverted.push_back(dice.percent(10) ? as_pattern(dice, row.name) : row.name);
  }
  return inverted;
}

description::Description random_description(Dice& dice, const PlannedPlant& plan, const std::vector<Row>& rows) {
  description::Description description;
  description.defaults.travel = dice.percent(25) ? tables::kSecond : random_time(dice);
  description.defaults.dwell = dice.percent(25) ? tables::kSecond : random_time(dice);
  if (dice.percent(30)) description.defaults.actuation = static_cast<Actuation>(dice.below(4));
  if (dice.percent(60)) description.defaults.overrun = random_overrun(dice);
  if (dice.percent(15)) description.defaults.sequence = random_sequence(dice);
  description.inverted = random_inverted(dice, rows);
  description.follow = random_follow(dice, plan);
  for (const PlannedUnit& unit : plan.units) {
    const bool must = unit.behaves || !unit.added.empty() || !unit.commands.empty() || !unit.signals.empty();
    if (must || dice.percent(55))
      description.devices.push_back(DeviceWriter(dice, plan, unit, description.follow).write());
  }
  if (dice.percent(45)) {
    for (std::size_t i = 1 + dice.below(3); i > 0; --i) {
      description.requirements.push_back(random_requirement(dice, plan, i));
    }
  }
  return description;
}

}  // namespace symplant::property
