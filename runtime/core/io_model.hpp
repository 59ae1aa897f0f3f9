// The functions of the I/O model as look-ups in a type's table, for generated classes to be read and used by people.
//
// Park, Wang and Park, "Symbol naming rules for plant model generation in the PLC simulation": a device is
// <I, O, S, d_int, d_ext, l_enter, l_leave, l_disable>. The engine does not call these; it has the tables.
#pragma once

#include <cstdint>
#include <span>

#include "symplant/core/tables.hpp"

namespace symplant::core {

/// Where operation `x` leads from state `a`; `a` itself where it leads nowhere from there. O(transitions).
template <class State, class Operation>
constexpr State d_ext(std::span<const Transition> transitions, State a, Operation x) noexcept {
  for (const Transition& t : transitions) {
    if (t.from == static_cast<std::uint8_t>(a) && t.on == static_cast<std::uint8_t>(x)) return static_cast<State>(t.to);
  }
  return a;
}

/// Where state `b` leads by itself; `b` itself where it stays. O(transitions).
template <class State>
constexpr State d_int(std::span<const Transition> transitions, State b) noexcept {
  for (const Transition& t : transitions) {
    if (t.from == static_cast<std::uint8_t>(b) && t.on == kNoOperation) return static_cast<State>(t.to);
  }
  return b;
}

}  // namespace symplant::core
