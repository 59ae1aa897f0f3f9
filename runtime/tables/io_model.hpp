// The functions of the I/O model as look-ups in a type's table, for use in generated classes.
//
// Park, Wang and Park, "Symbol naming rules for plant model generation in the PLC simulation": a device is
// <I, O, S, d_int, d_ext, l_enter, l_leave, l_disable>. The engine reads the tables and does not call these functions.
// They return the structure only: whether the condition of a transition holds (Transition::when) depends on a running
// plant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// The state that operation `x` leads to from state `a`, by the first transition that it commands there, with or
/// without a condition; `a` itself if there is no such transition. O(transitions).
template <class State, class Operation>
constexpr State d_ext(std::span<const Transition> transitions, State a, Operation x) noexcept {
  for (const Transition& t : transitions) {
    if (t.from == static_cast<std::uint8_t>(a) && t.on == static_cast<std::uint8_t>(x)) return static_cast<State>(t.to);
  }
  return a;
}

/// The state that state `b` leads to automatically, by the first such transition, with or without a condition; `b`
/// itself if there is no such transition. O(transitions).
template <class State>
constexpr State d_int(std::span<const Transition> transitions, State b) noexcept {
  for (const Transition& t : transitions) {
    if (t.from == static_cast<std::uint8_t>(b) && t.on == kNoOperation) return static_cast<State>(t.to);
  }
  return b;
}

/// The units that device `by` disables while it is settled in `x`, as rows of a plant's disables, which are sorted.
/// O(log rows).
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
