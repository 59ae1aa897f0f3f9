// Why a device moves, and why it stays.
#include <fmt/format.h>

#include <algorithm>

#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/why/walk.hpp"

namespace symplant::why {
/// `goals`: the states to which it should go; none: any other one.
Explanation Walk::unit(std::uint32_t unit, const States& goals) {
  const Reference self{Reference::Kind::unit, unit};
  Explanation result{unit_head(unit), {self}, {}};
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  const plant::UnitView now = view_.unit(unit);
  if (now.frozen) {
    result.sentence += ": it is in an instantaneous loop, and stays frozen until the run ends";
    return result;
  }
  if (now.disabled) {
    result.sentence += led_words(unit);
    append(result.because, causes(disablers(unit), [this](std::uint32_t by) { return this->unit(by); }));
  } else if (now.moving) {
    add_move(unit, now, result);
  } else {
    add_stay(unit, now.state, goals, result);
    add_behaviour(unit, result);
    if (is_asked_ && path_.size() == 1) add_last_command(unit, result);
  }
  add_forced(unit, result);
  return result;
}

/// What led a unit to its state.
Explanation Walk::led_unit(std::uint32_t unit) {
  Explanation result{unit_head(unit) + led_words(unit), {{Reference::Kind::unit, unit}}, {}};
  add_forced(unit, result);
  return result;
}

/// A line for each forced symbol of a unit that is not mentioned yet.
void Walk::add_forced(std::uint32_t unit, Explanation& result) {
  if (is_deepest()) return;
  const auto has = [](const Explanation& explanation, const Reference& thing) {
    return std::find(explanation.about.begin(), explanation.about.end(), thing) != explanation.about.end();
  };
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    const Reference self{Reference::Kind::symbol, symbol};
    const std::string forced = view_.forced(symbol);
    if (forced.empty() || done_.contains(self) || has(result, self)) continue;
    const auto& causes = result.because;
    if (std::any_of(causes.begin(), causes.end(), [&](const Explanation& cause) { return has(cause, self); })) continue;
    result.because.push_back({fmt::format("{} is forced to {} {}", names_.symbol(symbol),
                                          trace::value_text(tables_.symbols[symbol], view_.value(symbol)), forced),
                              {self},
                              {}});
  }
}

/// The command before a settled unit came to its state, if it is off now.
void Walk::add_last_command(std::uint32_t unit, Explanation& result) const {
  const std::vector<std::uint32_t> risen = risen_operations(unit);
  if (risen.empty() || commands(risen.front()) || view_.rose(risen.front()) > view_.unit_since(unit)) return;
  result.because.push_back(
      {"before that, " + last_words(risen.front()), {{Reference::Kind::symbol, risen.front()}}, {}});
}

/// A custom behavior that asks for states itself.
void Walk::add_behaviour(std::uint32_t unit, Explanation& result) const {
  const tables::BehaviourUnit* const behaviour = index_.behaviour_of(unit);
  if (is_deepest() || behaviour == nullptr || behaviour->name >= behaviours_.size()) return;
  if (behaviours_[behaviour->name].wanted == nullptr) return;
  result.because.push_back(
      {fmt::format("the custom behavior `{}` asks for no other state", index_.behaviour_names[behaviour->name]),
       {},
       {}});
}

void Walk::add_move(std::uint32_t unit, const plant::UnitView& now, Explanation& result) {
  if (now.stopped_midway) {
    add_stop(unit, now, result);
    return;
  }
  result.sentence += led_words(unit);
  const auto remaining = view_.remaining(unit);
  if (remaining && *remaining != tables::kNever) {
    result.sentence += fmt::format(", and arrives in {}", trace::seconds(*remaining));
  }
}

/// Why a unit has stopped midway.
void Walk::add_stop(std::uint32_t unit, const plant::UnitView& now, Explanation& result) {
  const tables::TypeRow& type = type_of(unit);
  std::vector<std::uint32_t> forth;
  std::vector<std::uint32_t> on;
  for (const tables::Transition& transition : type.transitions) {
    if (transition.from != now.state || transition.to != now.target) continue;
    if (transition.during != tables::kNoCondition &&
        add_need(result, ": `while`", index_.condition_of(unit, transition.during))) {
      return;
    }
    if (transition.on < tables::kMaxOperations) forth.push_back(index_.operation_of(unit, transition.on));
  }
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    const bool bit = tables_.symbols[symbol].type() == tables::DataType::boolean;
    if (bit && names_.is_operation(symbol) && commands(symbol)) on.push_back(symbol);
  }
  const auto words = [&](std::uint32_t symbol) {
    const bool leads = std::find(forth.begin(), forth.end(), symbol) != forth.end();
    const std::string_view to = leads ? names_.state(unit, now.target) : std::string_view();
    return Explanation{operation_words(symbol, to), {{Reference::Kind::symbol, symbol}}, {}};
  };
  const bool goes_forth = std::any_of(forth.begin(), forth.end(), [this](std::uint32_t s) { return commands(s); });
  if (goes_forth) {
    add_causes(result, on, "it has commands in both directions", words);
    return;
  }
  add_causes(result, forth, "it has no command to move on", words);
  append(result.because, causes(on, words));
}

namespace {

const tables::TransitionTimes& times_of(const tables::PlantTables& tables, const tables::UnitRow& row,
                                        std::uint16_t dt) {
  const bool own = (dt & tables::kOfDevice) != 0;
  return own ? tables.times[row.times + (dt & (tables::kOfDevice - 1U))] : tables.types[row.type].times[dt];
}

}  // namespace

/// Whether an operation leads to a state, by its name or by a transition.
bool Walk::leads_to(std::uint32_t unit, std::uint8_t operation, std::uint8_t state) const {
  const tables::TypeRow& type = type_of(unit);
  return type.operation_targets[operation] == state ||
         std::any_of(type.transitions.begin(), type.transitions.end(), [&](const tables::Transition& transition) {
           return transition.on == operation && transition.to == state;
         });
}

/// Whether the cause of a commanded transition holds and has held for its `after`.
bool Walk::is_ready(std::uint32_t unit, std::uint16_t transition) const {
  const tables::Transition& row = type_of(unit).transitions[transition];
  const std::uint32_t operation = index_.operation_of(unit, row.on);
  if (!commands(operation) || !view_.is_armed(operation).value_or(true)) return false;
  if (row.when != tables::kNoCondition && !holds(index_.condition_of(unit, row.when), view_)) return false;
  if (times_of(tables_, tables_.units[unit], row.dt).after == 0) return true;
  return view_.after_left(unit, transition) == tables::Time{0};
}

/// Commands to several states at once.
bool Walk::add_conflict(std::uint32_t unit, std::uint8_t here, Explanation& result) const {
  const tables::TypeRow& type = type_of(unit);
  States wanted;
  std::vector<bool> served(type.operations);
  std::vector<bool> taken(type.operations);
  const auto transitions = static_cast<std::uint16_t>(type.transitions.size());
  for (std::uint16_t n = 0; n < transitions; ++n) {
    const tables::Transition& transition = type.transitions[n];
    if (transition.from != here || transition.on >= type.operations || !is_ready(unit, n)) continue;
    wanted.set(transition.to);
    served[transition.on] = taken[transition.on] = true;
  }
  for (std::uint8_t operation = 0; operation < type.operations; ++operation) {
    const std::uint32_t symbol = index_.operation_of(unit, operation);
    if (served[operation] || !commands(symbol) || !view_.is_armed(symbol).value_or(true)) continue;
    if (!leads_to(unit, operation, here)) continue;
    wanted.set(here);
    taken[operation] = true;
  }
  if (wanted.count() < 2) return false;
  result.sentence += ": it has commands to several states at once and obeys none of them";
  for (std::uint8_t operation = 0; operation < type.operations; ++operation) {
    if (!taken[operation]) continue;
    const std::uint32_t symbol = index_.operation_of(unit, operation);
    result.sentence += ", " + operation_words(symbol);
    result.about.push_back({Reference::Kind::symbol, symbol});
  }
  return true;
}

void Walk::add_stay(std::uint32_t unit, std::uint8_t here, const States& goals, Explanation& result) {
  if (add_conflict(unit, here, result)) return;
  const tables::TypeRow& type = type_of(unit);
  const bool anywhere = goals.none() || goals[here];
  const States next = anywhere ? ~States() : next_states(type, here, goals);
  if (next.none()) {
    result.sentence += fmt::format(": no transition leads from there to {}", state_list(unit, goals));
    return;
  }
  if ((next & ~goals).any() && !anywhere) {
    result.sentence += fmt::format(", and goes to {} through {}", state_list(unit, goals), state_list(unit, next));
  }
  using Kind = Reason::Kind;
  std::vector<Reason> active;
  std::vector<Reason> off;
  std::vector<bool> starts(type.operations);
  const auto transitions = static_cast<std::uint16_t>(type.transitions.size());
  for (std::uint16_t n = 0; n < transitions; ++n) {
    const tables::Transition& transition = type.transitions[n];
    if (transition.from != here || transition.on == tables::kSpringReturn) continue;
    const bool commanded = transition.on != tables::kNoOperation;
    if (commanded) starts[transition.on] = true;
    if (!next[transition.to]) continue;
    const bool waits = !commanded || commands(index_.operation_of(unit, transition.on));
    (waits ? active : off).push_back({Kind::exit, n});
  }
  for (std::uint8_t operation = 0; operation < type.operations; ++operation) {
    const std::uint32_t symbol = index_.operation_of(unit, operation);
    if (!commands(symbol)) continue;
    if (leads_to(unit, operation, here)) {
      const bool holds = type.actuation == tables::Actuation::spring && here != type.rest && next[type.rest];
      (holds ? active : off).push_back({holds ? Kind::hold : Kind::here, symbol});
    } else if (!starts[operation]) {
      active.push_back({Kind::no_effect, symbol});
    }
  }
  const auto make = [&](const Reason& each) { return reason(unit, here, each); };
  if (!active.empty()) {
    add_causes(result, active, "it waits", make);
  } else if (!off.empty()) {
    add_causes(result, off, "it waits for a command", make);
  } else {
    result.sentence += type.operations == 0 ? ": no operation and no automatic transition moves it"
                                            : ": no transition leads from there";
  }
}

Explanation Walk::reason(std::uint32_t unit, std::uint8_t here, const Reason& reason) {
  if (reason.kind == Reason::Kind::exit) return exit(unit, static_cast<std::uint16_t>(reason.of));
  Explanation result{operation_words(reason.of), {{Reference::Kind::symbol, reason.of}}, {}};
  if (reason.kind == Reason::Kind::no_effect) {
    result.sentence += fmt::format(", but no transition on it starts from {}", names_.state(unit, here));
  } else if (reason.kind == Reason::Kind::hold) {
    result.sentence += fmt::format(", and goes to {} when it is {}", names_.state(unit, type_of(unit).rest),
                                   level_words(reason.of, false));
  } else {
    result.sentence += fmt::format(", and leads to {}", names_.state(unit, here));
  }
  return result;
}

/// Why a transition from a unit's state does not fire.
Explanation Walk::exit(std::uint32_t unit, std::uint16_t transition) {
  const tables::TypeRow& type = type_of(unit);
  const tables::Transition& row = type.transitions[transition];
  const std::string_view to = names_.state(unit, row.to);
  Explanation result;
  bool on = true;
  std::optional<bool> armed = true;
  if (row.on == tables::kNoOperation) {
    result.sentence = fmt::format("it goes to {} without a command", to);
  } else {
    const std::uint32_t operation = index_.operation_of(unit, row.on);
    result = {operation_words(operation, to), {{Reference::Kind::symbol, operation}}, {}};
    on = commands(operation);
    armed = view_.is_armed(operation);
  }
  if (!on || armed.value_or(true)) {
    const bool guarded = row.when != tables::kNoCondition;
    const std::string_view before = on ? ", but `when`" : ", and `when`";
    if (guarded && add_need(result, before, index_.condition_of(unit, row.when))) return result;
    if (!on) return result;
    const std::string after = after_words(unit, transition);
    result.sentence += after;
    if (!after.empty()) return result;
  }
  const bool used = type.actuation == tables::Actuation::latched && !armed.value_or(false);
  result.sentence += used ? ", but has no effect until it goes off and on again" : ", and is about to have its effect";
  return result;
}

/// How long the cause of a transition must still hold; empty if it need not hold for a time.
std::string Walk::after_words(std::uint32_t unit, std::uint16_t transition) const {
  const tables::Transition& row = type_of(unit).transitions[transition];
  const tables::Time after = times_of(tables_, tables_.units[unit], row.dt).after;
  const auto left = view_.after_left(unit, transition);
  const bool commanded = row.on != tables::kNoOperation;
  if (left && *left != tables::kNever && *left > 0) {
    return fmt::format("{} {}", commanded ? ", and has an effect in" : " in", trace::seconds(*left));
  }
  if (after == 0) return {};
  if (after < 0) return commanded ? ", and has an effect after a random time" : " after a random time";
  return fmt::format("{} {}", commanded ? ", and has an effect after" : " after", trace::seconds(after));
}

}  // namespace symplant::why
