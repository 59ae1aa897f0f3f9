// Resolves and expands given transitions and outputs.
#include "model/given.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "text/ascii.hpp"

namespace symplant::model {
namespace {

std::uint32_t find_task(std::string_view task, const std::vector<std::uint32_t>& side,
                        const std::vector<Symbol>& symbols) {
  for (std::uint32_t i = 0; i < side.size(); ++i) {
    if (text::equal_ignoring_case(symbols[side[i]].reading.task(), task)) return i;
  }
  return kNone;
}

std::string_view nearest_task(std::string_view task, const std::vector<std::uint32_t>& side,
                              const std::vector<Symbol>& symbols, const description::Faults& faults) {
  return faults.nearest(task, side.size(), [&](std::size_t i) { return symbols[side[i]].reading.task(); });
}

class TransitionExpander {
 public:
  TransitionExpander(Unit& unit, const std::vector<Symbol>& symbols, description::Faults& faults)
      : unit_(unit),
        symbols_(symbols),
        faults_(faults),
        pointer_(description::key_pointer(*unit.described, description::DeviceKey::transitions)) {}

  void run() {
    const auto& given = unit_.described->transitions;
    const std::vector<std::uint32_t> left_out = std::exchange(unit_.left_out, {});
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      if (std::binary_search(left_out.begin(), left_out.end(), i)) {
        unit_.left_out.push_back(i);
      } else {
        expand(given[i], i);
      }
      if (unit_.transitions.size() > tables::kMaxTransitions) return;  // derive_transitions() reports it
    }
  }

 private:
  std::uint32_t location_of(std::string_view when) {
    if (when.empty()) return kNone;
    return indexes_.try_emplace(when, static_cast<std::uint32_t>(indexes_.size())).first->second;
  }

  void expand(const description::GivenTransition& given, std::uint32_t index) {
    const description::Pointer here = pointer_ / std::size_t{index};
    const bool from_all = given.from == "*";
    const std::uint32_t to = given_state(unit_, given.to, here / "to", faults_);
    const std::uint32_t from = from_all ? kNone : given_state(unit_, given.from, here / "from", faults_);
    Transition transition;
    transition.origin = Origin::given;
    transition.given = static_cast<std::uint32_t>(index);
    transition.to = to;
    bool lacking = to == kNone || (!from_all && from == kNone);
    const bool sound = set_cause(transition, given, here, lacking);
    if (left_out(lacking)) {
      unit_.left_out.push_back(index);
      return;
    }
    transition.when = location_of(given.when);
    transition.during = location_of(given.during);
    if (!sound || lacking) return;
    if (from == to) {
      faults_.add(here,
                  "a transition cannot lead from " + description::ticked(given.to) + " to itself; name two states");
      return;
    }
    transition.after = given.after.value_or(description::Duration::fixed(0));
    transition.takes = given.takes.value_or(description::Duration::fixed(given.automatic ? 0 : unit_.travel));
    transition.once = given.once;
    transition.numbers = given.numbers;
    const auto count = static_cast<std::uint32_t>(unit_.states.size());
    for (std::uint32_t s = from_all ? 0 : from; s < (from_all ? count : from + 1); ++s) {
      transition.from = s;
      if (s != to && !add(transition, index)) return;
    }
  }

  /// Whether a transition is left out: the device lacks a name in it, and the transition is of a pattern.
  bool left_out(bool lacking) const { return lacking && pointer_.pattern() != nullptr; }

  /// Sets `on` or `spring_return` and checks the keys next to them. False if there is a fault; sets `lacking` if the
  /// operation is missing.
  bool set_cause(Transition& transition, const description::GivenTransition& given, const description::Pointer& here,
                 bool& lacking) {
    for (const tables::TransitionNumber& number : tables::kTransitionNumbers) {
      if (given.automatic || !number.automatic_only || given.numbers.*number.member == 0) continue;
      faults_.add(here / number.key, description::ticked(number.key) +
                                         " is only allowed in an automatic transition; remove it or add `automatic`");
      return false;
    }
    if (given.automatic) {
      if (!given.on.empty()) {
        faults_.add(here / "on", "an automatic transition has no operation; remove `on` or `automatic`");
      }
      if (given.once) faults_.add(here / "once", "`once` is not allowed in an automatic transition; remove it");
      return given.on.empty() && !given.once;
    }
    if (!given.on.empty()) {
      transition.on = find_task(given.on, unit_.operations, symbols_);
      if (transition.on == kNone) {
        lacking = true;
        faults_.lacks(here / "on", unit_.path, description::Named::operation, given.on, [&] {
          return description::missing(
              "operation " + description::ticked(given.on) + " of " + description::ticked(unit_.path),
              nearest_task(given.on, unit_.operations, symbols_, faults_));
        });
      }
    } else if (transition.to != kNone) {
      transition.on = unit_.states[transition.to].operation;
      if (transition.on == kNone && unit_.actuation == tables::Actuation::spring && transition.to == unit_.rest) {
        return !left_out(lacking) && set_spring_return(transition, given, here);
      }
      if (transition.on == kNone) {
        lacking = true;
        faults_.lacks(here / "to", unit_.path, description::Named::operation, given.to, [&] {
          return description::ticked(given.to) +
                 " has no operation of its name; name with `on` the one that commands the transition, " +
                 "or write `automatic` if none does";
        });
      }
    }
    if (left_out(lacking)) return false;
    if (given.once && unit_.actuation != tables::Actuation::latched) {
      faults_.add(here / "once", "`once` is not allowed in a device that is `" +
                                     std::string(description::actuation_name(unit_.actuation)) +
                                     "`; remove it or make the device `latched`");
      return false;
    }
    return transition.on != kNone;
  }

  bool set_spring_return(Transition& transition, const description::GivenTransition& given,
                         const description::Pointer& here) {
    transition.spring_return = true;
    bool sound = true;
    const auto refuse = [&](bool stands, std::string_view key) {
      if (!stands) return;
      faults_.add(here / key, description::ticked(key) +
                                  " is not allowed in the return of a spring, which has only `takes` and `while`;" +
                                  " remove it, or name with `on` the operation that commands the transition");
      sound = false;
    };
    refuse(!given.when.empty(), "when");
    refuse(given.after.has_value(), "after");
    refuse(given.once, "once");
    return sound;
  }

  /// False, and a fault, if the same transition exists.
  bool add(const Transition& transition, std::uint32_t index) {
    const std::uint64_t on = transition.spring_return ? tables::kSpringReturn
                             : transition.on == kNone ? tables::kNoOperation
                                                      : transition.on;
    const std::uint64_t key = std::uint64_t{transition.from} << 56 | std::uint64_t{transition.to} << 48 | on << 40 |
                              std::uint64_t{transition.when};
    const auto [first, added] = given_by_.try_emplace(key, index);
    if (!added) {
      const std::string from = description::ticked(unit_.states[transition.from].name);
      faults_.add(pointer_ / std::size_t{index},
                  "the transition from " + from + " to " + description::ticked(unit_.states[transition.to].name) +
                      " is also at " + description::ticked((pointer_ / std::size_t{first->second}).text()) +
                      ", with the same `on` and `when`; remove one");
      return false;
    }
    unit_.transitions.push_back(transition);
    return true;
  }

  Unit& unit_;
  const std::vector<Symbol>& symbols_;
  description::Faults& faults_;
  const description::Pointer pointer_;
  std::unordered_map<std::string_view, std::uint32_t> indexes_;  // a text of `when` or `while` -> its index
  std::unordered_map<std::uint64_t, std::uint32_t> given_by_;    // from, to, on, when -> a given transition
};

}  // namespace

GivenTransitions::GivenTransitions(const Unit& unit)
    : operations_(unit.operations.size()), states_(unit.states.size()) {
  if (unit.transitions.empty()) return;
  commanded_.resize(states_ * operations_);
  automatic_.resize(states_ * states_);
  led_to_.resize(states_);
  for (const Transition& transition : unit.transitions) {
    if (transition.on != kNone) {
      commanded_[transition.from * operations_ + transition.on] = true;
      led_to_[transition.to] = true;
    } else if (!transition.spring_return) {
      automatic_[transition.from * states_ + transition.to] = true;
    }
  }
}

void add_given_transitions(Unit& unit, const std::vector<Symbol>& symbols, description::Faults& faults) {
  TransitionExpander(unit, symbols, faults).run();
}

void add_outputs(Unit& unit, const std::vector<Symbol>& symbols, description::Faults& faults) {
  const auto& given = unit.described->outputs;
  if (given.empty()) return;
  const description::Pointer pointer = description::key_pointer(*unit.described, description::DeviceKey::outputs);
  std::vector<bool> seen(unit.states.size());
  unit.outputs.resize(unit.states.size());
  for (const description::GivenOutputs& output : given) {
    const description::Pointer here = pointer / output.state;
    const std::uint32_t state = given_state(unit, output.state, here, faults);
    if (state != kNone && seen[state])
      faults.add(here, description::ticked(output.state) + " appears twice; merge both");
    if (state != kNone) seen[state] = true;
    const auto switched = [&](const auto& list, std::string_view key) {
      std::vector<std::pair<std::uint32_t, bool>> events;
      for (const auto& [task, on] : list) {
        const std::uint32_t event = find_task(task, unit.events, symbols);
        if (event == kNone) {
          faults.lacks(here / key / task, unit.path, description::Named::event, task, [&, &name = task] {
            return description::missing("event " + description::ticked(name) + " of " + description::ticked(unit.path),
                                        nearest_task(name, unit.events, symbols, faults));
          });
        } else {
          events.emplace_back(event, on);
        }
      }
      return events;
    };
    Outputs outputs{switched(output.enter, "enter"), switched(output.leave, "leave")};
    if (state != kNone) unit.outputs[state] = std::move(outputs);
  }
}

std::uint32_t given_state(const Unit& unit, std::string_view name, const description::Pointer& pointer,
                          description::Faults& faults) {
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (text::equal_ignoring_case(unit.states[s].name, name)) return s;
  }
  faults.lacks(pointer, unit.path, description::Named::state, name, [&] {
    const auto nearest = faults.nearest(name, unit.states.size(),
                                        [&](std::size_t s) -> std::string_view { return unit.states[s].name; });
    return description::missing("state " + description::ticked(name) + " of " + description::ticked(unit.path),
                                nearest);
  });
  return kNone;
}

}  // namespace symplant::model
