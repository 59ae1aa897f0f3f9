// Why a unit moves, does not move on, or is kept from moving.
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

}  // namespace symplant::why
