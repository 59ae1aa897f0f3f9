// The functions of the I/O model as look-ups in a type's table, for generated classes to be read and used by people.
//
// Park, Wang and Park, "Symbol naming rules for plant model generation in the PLC simulation": a device is
// <I, O, S, d_int, d_ext, l_enter, l_leave, l_disable>. The engine does not call these; it has the tables. They tell
// the structure alone: whether a condition that guards a transition holds (Transition::when) only a running plant
// knows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// Where operation `x` leads from state `a`, by the first transition that it commands there, guarded or not; `a` itself
/// where it leads nowhere from there. O(transitions).
template <class State, class Operation>
constexpr State d_ext(std::span<const Transition> transitions, State a, Operation x) noexcept {
  for (const Transition& t : transitions) {
    if (t.from == static_cast<std::uint8_t>(a) && t.on == static_cast<std::uint8_t>(x)) return static_cast<State>(t.to);
  }
  return a;
}

/// Where state `b` leads by itself, by the first such transition, guarded or not; `b` itself where it stays.
/// O(transitions).
template <class State>
constexpr State d_int(std::span<const Transition> transitions, State b) noexcept {
  for (const Transition& t : transitions) {
    if (t.from == static_cast<std::uint8_t>(b) && t.on == kNoOperation) return static_cast<State>(t.to);
  }
  return b;
}

/// Whom device `by` disables while it is settled in `x`: rows of a plant's disables, which are sorted. O(log rows).
template <class State>
constexpr std::span<const DisableRow> l_disable(std::span<const DisableRow> disables, std::uint32_t by,
                                                State x) noexcept {
  const auto first_from = [&](unsigned state) {
    std::size_t first = 0;
    for (std::size_t count = disables.size(); count != 0;) {
      const DisableRow& middle = disables[first + count / 2];
      const bool before = middle.by < by || (middle.by == by && middle.state < state);
      first = before ? first + count / 2 + 1 : first;
      count = before ? count - count / 2 - 1 : count / 2;
    }
    return first;
  };
  const auto state = static_cast<std::uint8_t>(x);
  const std::size_t first = first_from(state);
  return disables.subspan(first, first_from(state + 1U) - first);
}

}  // namespace symplant::tables
