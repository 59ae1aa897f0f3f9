// Builds the row of a device type from the functions of its class, while compiling.
//
// Cost for g++ 12: about 10 ms a type of two states; a class of 40 operations and 40 states about one second.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "symplant/tables/io_model.hpp"

namespace symplant::tables {

/// The functions of an I/O model, as bits of a set.
enum class ModelFunction : std::uint8_t { d_ext = 1, d_int = 2, l_enter = 4, l_leave = 8 };

namespace detail {

template <class Class>
concept ConstexprModel = requires {
  typename std::bool_constant<(Class::d_ext(typename Class::State{}, typename Class::Operation{}),
                               Class::d_int(typename Class::State{}), Class::l_enter(typename Class::State{}),
                               Class::l_leave(typename Class::State{}), true)>;
};

/// Refuses, in words, a derived class that is not a model of its base's states, operations, events and guards.
template <class Class, class Base>
constexpr bool check_model() noexcept {
  static_assert(std::is_base_of_v<Base, Class>, "a behavior must derive from the generated class of its devices");
  static_assert(std::is_same_v<typename Class::State, typename Base::State> &&
                    std::is_same_v<typename Class::Operation, typename Base::Operation> &&
                    std::is_same_v<typename Class::Event, typename Base::Event> &&
                    std::is_same_v<typename Class::Guard, typename Base::Guard>,
                "a derived class has the State, Operation, Event and Guard of its base: remove its own");
  static_assert(&Class::kI == &Base::kI && &Class::kO == &Base::kO && &Class::kS == &Base::kS &&
                    &Class::kTargets == &Base::kTargets && &Class::kRest == &Base::kRest &&
                    &Class::kActuation == &Base::kActuation,
                "a derived class may replace d_ext, d_int, l_enter and l_leave; states, rest and actuation are in the "
                "plant's description");
  static_assert(std::is_same_v<decltype(&Class::d_ext), decltype(&Base::d_ext)>,
                "declare `static constexpr Moves d_ext(State a, Operation x) noexcept` once, as a public member");
  static_assert(std::is_same_v<decltype(&Class::d_int), decltype(&Base::d_int)>,
                "declare `static constexpr Moves d_int(State b) noexcept` once, as a public member");
  static_assert(std::is_same_v<decltype(&Class::l_enter), decltype(&Base::l_enter)>,
                "declare `static constexpr EventMasks l_enter(State x) noexcept` once, as a public member");
  static_assert(std::is_same_v<decltype(&Class::l_leave), decltype(&Base::l_leave)>,
                "declare `static constexpr EventMasks l_leave(State x) noexcept` once, as a public member");
  static_assert(ConstexprModel<Class>,
                "d_ext, d_int, l_enter and l_leave are called while compiling: declare them `constexpr`");
  return ConstexprModel<Class>;
}

/// A move with its cause.
template <class State>
struct Caused {
  std::uint8_t from = 0;
  std::uint8_t on = 0;
  Move<State> move{};
};

template <class Class>
struct RowOf {
  using State = typename Class::State;

  static constexpr std::size_t kStates = Class::kS.size();
  static constexpr bool kCustom = requires { typename Class::View; };

  /// act(from, on, move) for every move: first the commanded ones, by source and operation, then the automatic ones,
  /// then the returns of a spring.
  template <class Act>
  static constexpr void each_move(Act act) noexcept {
    for (const State from : Class::kS) {
      for (const auto x : Class::kI) {
        for (const auto& move : Class::d_ext(from, x)) act(from, static_cast<std::uint8_t>(x), move);
      }
    }
    for (const State from : Class::kS) {
      for (const auto& move : Class::d_int(from)) act(from, kNoOperation, move);
    }
    if constexpr (requires { Class::spring_return(State{}); }) {
      for (const State from : Class::kS) {
        for (const auto& move : Class::spring_return(from)) act(from, kSpringReturn, move);
      }
    }
  }

  static constexpr std::size_t count() noexcept {
    std::size_t count = 0;
    each_move([&](State, std::uint8_t, const auto&) { ++count; });
    return count;
  }
  static constexpr std::size_t kCount = count();
  static_assert(kCount <= kMaxTransitions, "a device has at most 65,534 moves");

  static constexpr std::size_t kind_of(std::uint8_t on) noexcept {
    return on == kSpringReturn ? 2 : on == kNoOperation ? 1 : 0;
  }

  /// All moves, those of one kind by target, then by source, then by operation (a counting sort).
  static constexpr auto by_target() noexcept {
    std::array<std::size_t, 3 * kStates + 1> begin{};
    const auto place = [](std::uint8_t on, State to) { return kind_of(on) * kStates + static_cast<std::size_t>(to); };
    each_move([&](State, std::uint8_t on, const auto& move) { ++begin[place(on, move.to) + 1]; });
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::array<Caused<State>, kCount> sorted{};
    each_move([&](State from, std::uint8_t on, const auto& move) {
      sorted[begin[place(on, move.to)]++] = {static_cast<std::uint8_t>(from), on, move};
    });
    return sorted;
  }

  /// The same, by priority first. O(moves) for each priority.
  static constexpr auto by_priority() noexcept {
    const auto moves = by_target();
    std::array<Caused<State>, kCount> sorted{};
    std::size_t size = 0;
    for (std::uint32_t priority = 0; size < kCount;) {
      std::uint32_t next = kLast;
      for (const Caused<State>& caused : moves) {
        if (caused.move.order == priority) sorted[size++] = caused;
        if (caused.move.order > priority && caused.move.order < next) next = caused.move.order;
      }
      priority = next;
    }
    return sorted;
  }
  static constexpr auto kMoves = by_priority();

  struct Times {
    std::array<TransitionTimes, kCount + 1> rows{};
    std::size_t size = 0;

    /// Transition::dt; adds the times if no transition before has them.
    constexpr std::uint16_t number(const Dt& dt) noexcept {
      if (dt.own != 0) return dt.own;
      for (std::size_t i = size; i-- > 0;) {
        if (rows[i].after == dt.after && rows[i].takes == dt.takes) return static_cast<std::uint16_t>(i);
      }
      rows[size] = {dt.after, dt.takes};
      return static_cast<std::uint16_t>(size++);
    }
  };

  struct All {
    std::array<Transition, kCount> transitions{};
    Times times{};
    std::uint16_t travel = 0;
  };
  static constexpr All all() noexcept {
    All all;
    for (std::size_t i = 0; i < kCount; ++i) {
      const Move<State>& move = kMoves[i].move;
      const bool timed = move.dt.own != 0 ? move.dt.own_after : move.dt.after != 0 || move.dt.takes < 0;
      all.transitions[i] = {
          kMoves[i].from,   static_cast<std::uint8_t>(move.to), kMoves[i].on, move.disarms, move.guard,
          timed || kCustom, all.times.number(move.dt)};
    }
    if constexpr (requires { Class::dt_without_command; }) all.travel = all.times.number(Class::dt_without_command);
    return all;
  }
  static constexpr All kAll = all();
  static constexpr auto kTimes = [] {
    std::array<TransitionTimes, kAll.times.size> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = kAll.times.rows[i];
    return rows;
  }();
  static constexpr auto kTransitions = kAll.transitions;

  template <class Function>
  static constexpr auto masks(Function function) noexcept {
    std::array<EventMasks, kStates> rows{};
    for (const State x : Class::kS) rows[static_cast<std::size_t>(x)] = function(x);
    return rows;
  }
  static constexpr auto kEnter = masks([](State x) { return Class::l_enter(x); });
  static constexpr auto kLeave = masks([](State x) { return Class::l_leave(x); });
  static constexpr auto kTargets = [] {
    std::array<std::uint8_t, Class::kTargets.size()> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::uint8_t>(Class::kTargets[i]);
    return rows;
  }();

  static constexpr bool leads_to_itself() noexcept {
    for (const Caused<State>& caused : kMoves) {
      if (caused.from == static_cast<std::uint8_t>(caused.move.to)) return true;
    }
    return false;
  }
  static constexpr bool sound(const EventMasks& masks) noexcept {
    const std::uint64_t none = Class::kO.size() == kMaxEvents ? 0 : ~std::uint64_t{0} << Class::kO.size();
    return (masks.on & masks.off) == 0 && ((masks.on | masks.off) & none) == 0;
  }
  static constexpr bool switches_soundly() noexcept {
    for (std::size_t s = 0; s < kStates; ++s) {
      if (!sound(kEnter[s]) || !sound(kLeave[s])) return false;
    }
    return true;
  }
  static_assert(!leads_to_itself(), "a move cannot lead from a state to itself: return kStay");
  static_assert(switches_soundly(), "l_enter and l_leave switch events of their device, each either on or off");
};

}  // namespace detail

/// The row of a device type, for the engine: that of the generated class `Base`, or of a class that the user derived
/// from it and that replaces some of d_ext, d_int, l_enter and l_leave.
template <class Class, class Base = Class>
constexpr TypeRow row_of() noexcept {
  if constexpr (detail::check_model<Class, Base>()) {
    using Row = detail::RowOf<Class>;
    return {static_cast<std::uint8_t>(Class::kI.size()),
            static_cast<std::uint8_t>(Class::kO.size()),
            static_cast<std::uint8_t>(Class::kS.size()),
            static_cast<std::uint8_t>(Class::kRest),
            Class::kActuation,
            Row::kTransitions,
            Row::kEnter,
            Row::kLeave,
            Row::kTargets,
            Row::kTimes,
            Row::kAll.travel};
  } else {
    return {};
  }
}

/// The functions of `Base` that `Class` replaces: values of ModelFunction, added.
template <class Class, class Base>
constexpr std::uint8_t replaced_in() noexcept {
  std::uint8_t replaced = 0;
  const auto add = [&](bool other, ModelFunction function) {
    if (other) replaced = static_cast<std::uint8_t>(replaced | static_cast<std::uint8_t>(function));
  };
  if constexpr (detail::check_model<Class, Base>()) {
    add(&Class::d_ext != &Base::d_ext, ModelFunction::d_ext);
    add(&Class::d_int != &Base::d_int, ModelFunction::d_int);
    add(&Class::l_enter != &Base::l_enter, ModelFunction::l_enter);
    add(&Class::l_leave != &Base::l_leave, ModelFunction::l_leave);
  }
  return replaced;
}

}  // namespace symplant::tables
