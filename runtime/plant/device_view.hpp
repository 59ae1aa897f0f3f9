// A device as a custom behavior sees it, with the enumerators of its generated class (docs/behaviours.md).
//
// `Device` is a generated class: it has State, Operation, Event, Input and Value, and `kV`, one ValueKind per Value.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "symplant/engine/behaviour.hpp"
#include "symplant/plant/behaviour_memory.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::plant {

/// The type and the direction of a numeric symbol of a device.
struct ValueKind {
  tables::DataType type;
  tables::Direction direction;
};

/// Zero, in the C++ type for a numeric type: an integer of its size, `double` for REAL and LREAL.
template <tables::DataType Type>
constexpr auto zero_of() noexcept {
  static_assert(Type != tables::DataType::boolean, "a BOOL is not a number");
  if constexpr (Type == tables::DataType::sint) return std::int8_t{0};
  if constexpr (Type == tables::DataType::int_) return std::int16_t{0};
  if constexpr (Type == tables::DataType::dint) return std::int32_t{0};
  if constexpr (Type == tables::DataType::lint) return std::int64_t{0};
  if constexpr (Type == tables::DataType::usint || Type == tables::DataType::byte) return std::uint8_t{0};
  if constexpr (Type == tables::DataType::uint || Type == tables::DataType::word) return std::uint16_t{0};
  if constexpr (Type == tables::DataType::udint || Type == tables::DataType::dword) return std::uint32_t{0};
  if constexpr (Type == tables::DataType::ulint || Type == tables::DataType::lword) return std::uint64_t{0};
  if constexpr (Type == tables::DataType::real || Type == tables::DataType::lreal) return 0.0;
}
template <tables::DataType Type>
using NumberOf = decltype(zero_of<Type>());

/// A transition of the device's table, or a move without a command (a spring return, for example).
template <class Device>
class DeviceTransition {
 public:
  using State = typename Device::State;
  using Operation = typename Device::Operation;

  /// `number` is the argument of `takes` and `after`: a transition of the table, or 0xFFFF.
  DeviceTransition(const engine::BehaviourView& view, std::uint16_t number) noexcept
      : from_(static_cast<State>(view.state())), to_(static_cast<State>(view.leads_to())), number_(number) {
    const tables::Transition* row = view.transition(number);
    if (row == nullptr) return;
    from_ = static_cast<State>(row->from);
    to_ = static_cast<State>(row->to);
    if (row->on < tables::kMaxOperations) on_ = static_cast<Operation>(row->on);
  }

  State from() const noexcept { return from_; }
  State to() const noexcept { return to_; }
  /// The operation that commands it; empty if it is automatic or a move without a command.
  std::optional<Operation> on() const noexcept { return on_; }
  /// Its index in the table of the device, from 0; 0xFFFF for a move without a command.
  std::uint16_t number() const noexcept { return number_; }

 private:
  State from_;
  State to_;
  std::optional<Operation> on_;
  std::uint16_t number_;
};

/// What every function of a custom behavior may read. Valid only during the call; all members O(1).
template <class Device>
class DeviceLook {
 public:
  using State = typename Device::State;
  using Operation = typename Device::Operation;
  using Event = typename Device::Event;
  using Input = typename Device::Input;
  using Value = typename Device::Value;

  explicit DeviceLook(engine::BehaviourView& view) noexcept : view_(view) {}

  tables::Time now() const noexcept { return view_.now(); }  ///< plant time of this instant, ns
  /// The state in which the device is settled, or from which it moves. `target()` is the state that it moves to, or
  /// `state()` if it is settled.
  State state() const noexcept { return static_cast<State>(view_.state()); }
  State target() const noexcept { return static_cast<State>(view_.target()); }
  bool moving() const noexcept { return view_.moving(); }
  /// Whether the operation is on after forces, and armed.
  bool operation(Operation operation) const noexcept { return view_.operation(static_cast<std::uint8_t>(operation)); }
  /// The event as the device itself last set it.
  bool event(Event event) const noexcept { return view_.event(static_cast<std::uint8_t>(event)); }
  /// Whether a condition of the description's `inputs` holds, as published before this round.
  bool input(Input input) const noexcept { return view_.input(static_cast<std::uint32_t>(input)); }
  /// A numeric symbol: an operation after forces, an event as the device itself last set it. A forced integer out of
  /// its type's range is truncated to the type.
  template <Value Symbol>
  auto value() const noexcept {
    using Number = NumberOf<kind_of<Symbol>().type>;
    const std::uint64_t bits = view_.value(static_cast<std::uint32_t>(Symbol));
    if constexpr (std::is_floating_point_v<Number>) {
      return std::bit_cast<double>(bits);
    } else {
      return static_cast<Number>(bits);
    }
  }
  /// Whether the link that carries the device's operations is connected.
  bool quality() const noexcept { return view_.quality(); }
  template <class Memory>
  const Memory& memory() const noexcept {
    check_behaviour_memory<Memory>();
    return view_.template memory<Memory>();
  }

  /// 64 random bits. The draws are counted, so a restored plant continues with the same numbers. Not for `wanted`: how
  /// often the engine calls it is unspecified.
  std::uint64_t draw() noexcept { return view_.draw(); }
  /// The time by the model's rule: model_takes() in `takes`, model_after() in `after`, for their transition. A random
  /// time is drawn, and the draw is counted.
  tables::Time model_takes(const DeviceTransition<Device>& transition) noexcept {
    return view_.model_takes(transition.number());
  }
  tables::Time model_after(const DeviceTransition<Device>& transition) noexcept {
    return view_.model_after(transition.number());
  }

 protected:
  template <Value Symbol>
  static constexpr ValueKind kind_of() noexcept {
    static_assert(static_cast<std::size_t>(Symbol) < Device::kV.size(), "the device has no such numeric symbol");
    return Device::kV[static_cast<std::size_t>(Symbol)];
  }
  engine::BehaviourView& view() noexcept { return view_; }

 private:
  engine::BehaviourView& view_;
};

/// What `started`, `entered`, `left` and `woken` may read and do.
template <class Device>
class DeviceView : public DeviceLook<Device> {
 public:
  using typename DeviceLook<Device>::Event;
  using typename DeviceLook<Device>::Value;
  using DeviceLook<Device>::DeviceLook;

  void set_event(Event event, bool on) noexcept { this->view().set_event(static_cast<std::uint8_t>(event), on); }
  /// Sets a numeric event. A REAL is rounded to 32 bits, as the PLC reads it.
  template <Value Symbol>
  void set_value(NumberOf<DeviceLook<Device>::template kind_of<Symbol>().type> number) noexcept {
    constexpr ValueKind kKind = DeviceLook<Device>::template kind_of<Symbol>();
    static_assert(kKind.direction == tables::Direction::event,
                  "this symbol is an operation, which only the PLC writes; set an event");
    std::uint64_t bits = 0;
    if constexpr (kKind.type == tables::DataType::real) {
      bits = std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(number)));
    } else if constexpr (kKind.type == tables::DataType::lreal) {
      bits = std::bit_cast<std::uint64_t>(number);
    } else if constexpr (std::is_signed_v<decltype(number)>) {
      bits = static_cast<std::uint64_t>(std::int64_t{number});
    } else {
      bits = number;
    }
    this->view().set_value(static_cast<std::uint32_t>(Symbol), bits);
  }
  /// Requests one call of `woken` at `time`; it replaces an earlier request. A time in the past means now; kNever
  /// cancels the request. The remaining time does not run while the device is disabled.
  void wake_at(tables::Time time) noexcept { this->view().wake_at(time); }
  void wake_after(tables::Time duration) noexcept {
    const tables::Time now = this->now();
    wake_at(duration > std::numeric_limits<tables::Time>::max() - now ? tables::kNever : now + duration);
  }
  template <class Memory>
  Memory& memory() noexcept {
    check_behaviour_memory<Memory>();
    return this->view().template memory<Memory>();
  }
};

}  // namespace symplant::plant
