// The types and helpers with which a generated device class is written: its I/O model and what its functions return.
//
// Park, Wang and Park, "Symbol naming rules for plant model generation in the PLC simulation": a device is
// <I, O, S, d_int, d_ext, l_enter, l_leave, l_disable>. row_of() calls d_ext, d_int, l_enter and l_leave while
// compiling and builds the row on which the engine runs: the functions are the model.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "symplant/tables/hooks.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// dt of a transition: how long its cause must hold before the device leaves its state (0: it leaves at once), and the
/// travel time, both in ns, >= 0.
struct Dt {
  Time after = 0;
  Time takes = 0;
  std::uint16_t own = 0;   ///< kOfDevice and an index: each device has its own time, in its rows
  bool own_after = false;  ///< that time may have a delay or be random

  friend constexpr bool operator==(const Dt&, const Dt&) noexcept = default;
};

/// The guard of a move without a condition.
struct Unguarded {};
inline constexpr std::uint16_t kLast = 0xFFFF;  ///< the priority of a move for which none is given

/// One move out of a state: where it leads, how long that takes, and what else it needs.
template <class State, class Guard = Unguarded>
struct Move {
  State to;
  Dt dt;
  std::uint16_t guard = kNoCondition;
  std::uint16_t order = kLast;
  bool disarms = false;
  std::uint16_t going = kNoCondition;
  TransitionNumbers numbers{};

  /// It starts only while a condition of the device holds.
  template <class Condition>
  constexpr Move<State, Condition> when(Condition condition) const noexcept {
    return {to, dt, static_cast<std::uint16_t>(condition), order, disarms, going, numbers};
  }
  /// It stops while a condition of the device does not hold, and then continues (`while` in plant.json).
  template <class Condition>
  constexpr Move<State, Condition> during(Condition condition) const noexcept {
    return {to, dt, guard, order, disarms, static_cast<std::uint16_t>(condition), numbers};
  }
  /// Of several moves of d_int that are ready at once one is drawn, by weights from 1 to 1,000,000.
  constexpr Move weight(std::uint32_t number) const noexcept {
    Move move = *this;
    move.numbers.weight = number;
    return move;
  }
  /// Its operation works once: it must be off before it starts the move again (latched devices only).
  constexpr Move once() const noexcept {
    Move move = *this;
    move.disarms = true;
    return move;
  }
  /// Of several moves that are ready at once, the first of the lowest priority number is taken; those without a number
  /// come last.
  constexpr Move priority(std::uint16_t number) const noexcept {
    Move move = *this;
    move.order = number;
    return move;
  }
};

struct Stay {};

/// Where a device goes: nowhere (IoModel::kStay), one move, or several, of which the guards decide.
template <class State, class Guard, std::size_t Most = 4>
class Moves {
 public:
  constexpr Moves(Stay) noexcept : moves_{}, size_(0) {}
  template <class... Each>
  constexpr Moves(Each... moves) noexcept : moves_{plain(moves)...}, size_(sizeof...(moves)) {
    static_assert(sizeof...(moves) <= Most, "too many moves for one state and operation");
  }

  constexpr const Move<State>* begin() const noexcept { return moves_.data(); }
  constexpr const Move<State>* end() const noexcept { return moves_.data() + size_; }
  constexpr std::size_t size() const noexcept { return size_; }
  /// Whether one of the moves leads to a state, with or without a guard.
  constexpr bool lead_to(State state) const noexcept {
    for (const Move<State>& move : *this) {
      if (move.to == state) return true;
    }
    return false;
  }

 private:
  template <class To, class Condition>
  static constexpr Move<State> plain(const Move<To, Condition>& move) noexcept {
    static_assert(std::is_same_v<To, State>, "a move leads to a State of its class: use the State of the base");
    static_assert(std::is_same_v<Condition, Unguarded> || std::is_same_v<Condition, Guard>,
                  "a move has a Guard of its class: use the Guard of the base");
    if constexpr (std::is_same_v<To, State>) {
      return {move.to, move.dt, move.guard, move.order, move.disarms, move.going, move.numbers};
    }
    return {};
  }

  std::array<Move<State>, Most> moves_;
  std::size_t size_;
};

/// Events of a class that are switched together, a bit each as in EventMasks.
template <class Event>
struct EventSet {
  std::uint64_t on = 0;
  std::uint64_t off = 0;

  /// The union of both; an event must not be switched on by one and off by the other.
  friend constexpr EventSet operator|(const EventSet& a, const EventSet& b) noexcept {
    return {a.on | b.on, a.off | b.off};
  }
};

/// The base of generated classes: the names that their functions use, and the defaults of a class without guards,
/// spring or automatic transitions. No data.
struct IoModel {
  enum class Guard : std::uint16_t {};  ///< a class with guards has its own
  using Dt = tables::Dt;
  using Actuation = tables::Actuation;
  using Time = tables::Time;
  using Hook = tables::Hook;
  template <Hook... Listed>
  using Hooks = tables::Hooks<Listed...>;
  static constexpr Stay kStay{};
  static constexpr std::uint8_t kNoState = tables::kNoState;
  static constexpr Time kNanosecond = tables::kNanosecond;
  static constexpr Time kMicrosecond = tables::kMicrosecond;
  static constexpr Time kMillisecond = tables::kMillisecond;
  static constexpr Time kSecond = tables::kSecond;

  /// The move to a state.
  template <class State>
  static constexpr Move<State> go(State to, Dt dt) noexcept {
    return {to, dt};
  }
  /// Each device has its own travel time, in its rows, and leaves at once.
  static constexpr Dt own_travel(std::uint16_t index) noexcept {
    return {0, 0, static_cast<std::uint16_t>(kOfDevice | index), false};
  }
  /// Each device has its own delay and travel time, in its rows.
  static constexpr Dt own_dt(std::uint16_t index) noexcept {
    return {0, 0, static_cast<std::uint16_t>(kOfDevice | index), true};
  }
  /// A time that is drawn each time it is needed: row `index` of PlantTables::random_times.
  static constexpr Time random_time(std::uint32_t index) noexcept { return -1 - static_cast<Time>(index); }
  /// The events that are switched on, and those that are switched off: `on(Event::I_A) | off(Event::I_B)`.
  template <class Event, std::same_as<Event>... More>
  static constexpr EventSet<Event> on(Event event, More... more) noexcept {
    return {(bit(event) | ... | bit(more)), 0};
  }
  template <class Event, std::same_as<Event>... More>
  static constexpr EventSet<Event> off(Event event, More... more) noexcept {
    return {0, (bit(event) | ... | bit(more))};
  }

 private:
  template <class Event>
  static constexpr std::uint64_t bit(Event event) noexcept {
    return std::uint64_t{1} << static_cast<std::uint8_t>(event);
  }
};

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
