// A device as the user's code sees it: its class's own enumerators instead of numbers (docs/behaviours.md).
//
// `Device` is a generated class: it has State, Operation, Event, Input and Value, and `kV`, a ValueKind a Value.
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

/// A numeric symbol of a device: its type, and who writes it.
struct ValueKind {
  tables::DataType type;
  tables::Direction direction;
};

/// A value of the C++ type that stands for a numeric type: an integer of its size, `double` for REAL and LREAL.
template <tables::DataType Type>
constexpr auto zero_of() noexcept {
  static_assert(Type != tables::DataType::boolean, "a bit is no number");
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

/// A way that the device may take: a transition of its table, or one without a command (a spring's own, say).
template <class Device>
class DeviceTransition {
 public:
  using State = typename Device::State;
  using Operation = typename Device::Operation;

  /// What `takes` and `after` are asked for: a transition of the table, or 0xFFFF.
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
  /// The operation that commands it; nothing where it is automatic or a way without a command.
  std::optional<Operation> on() const noexcept { return on_; }
  /// Its place in the table of the device, from 0; 0xFFFF: none, a way without a command.
  std::uint16_t number() const noexcept { return number_; }

 private:
  State from_;
  State to_;
  std::optional<Operation> on_;
  std::uint16_t number_;
};

/// What every function of a behaviour may look at. Valid only while it is called; all members O(1).
template <class Device>
class DeviceLook {
 public:
  using State = typename Device::State;
  using Operation = typename Device::Operation;
  using Event = typename Device::Event;
  using Input = typename Device::Input;
  using Value = typename Device::Value;

  explicit DeviceLook(engine::BehaviourView& view) noexcept : view_(view) {}

  tables::Time now() const noexcept { return view_.now(); }  ///< of this instant: ns of plant time
  /// Settled in, or moving from; `target()` is where to, the same where it is settled.
  State state() const noexcept { return static_cast<State>(view_.state()); }
  State target() const noexcept { return static_cast<State>(view_.target()); }
  bool moving() const noexcept { return view_.moving(); }
  /// On after forces, and armed.
  bool operation(Operation operation) const noexcept { return view_.operation(static_cast<std::uint8_t>(operation)); }
  /// As the device itself last set it.
  bool event(Event event) const noexcept { return view_.event(static_cast<std::uint8_t>(event)); }
  /// Whether a condition of the description's `inputs` holds, by the snapshot that the instant's round reads.
  bool input(Input input) const noexcept { return view_.input(static_cast<std::uint32_t>(input)); }
  /// A numeric symbol: an operation after forces, an event as the device itself last set it. Under a force an integer
  /// beyond its type's range is cut to it.
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
  /// Whether the link that carries the device's operations is well.
  bool quality() const noexcept { return view_.quality(); }
  template <class Memory>
  const Memory& memory() const noexcept {
    check_behaviour_memory<Memory>();
    return view_.template memory<Memory>();
  }

  /// 64 random bits, counted: a saved plant goes on with the same ones. Not in `wanted`, which is asked as often as the
  /// engine likes.
  std::uint64_t draw() noexcept { return view_.draw(); }
  /// In `takes` and `after`: what the model's own rule says of the transition that they are asked for. A random time is
  /// drawn by it.
  tables::Time model_takes(const DeviceTransition<Device>& transition) noexcept {
    return view_.model_takes(transition.number());
  }
  tables::Time model_after(const DeviceTransition<Device>& transition) noexcept {
    return view_.model_after(transition.number());
  }

 protected:
  template <Value Symbol>
  static constexpr ValueKind kind_of() noexcept {
    static_assert(static_cast<std::size_t>(Symbol) < Device::kV.size(), "the device has no such number");
    return Device::kV[static_cast<std::size_t>(Symbol)];
  }
  engine::BehaviourView& view() noexcept { return view_; }

 private:
  engine::BehaviourView& view_;
};

/// What `entered`, `left` and `woken` may do beyond looking.
template <class Device>
class DeviceView : public DeviceLook<Device> {
 public:
  using typename DeviceLook<Device>::Event;
  using typename DeviceLook<Device>::Value;
  using DeviceLook<Device>::DeviceLook;

  void set_event(Event event, bool on) noexcept { this->view().set_event(static_cast<std::uint8_t>(event), on); }
  /// Sets a numeric event. A REAL is rounded to 32 bits, as the PLC will see it.
  template <Value Symbol>
  void set_value(NumberOf<DeviceLook<Device>::template kind_of<Symbol>().type> number) noexcept {
    constexpr ValueKind kKind = DeviceLook<Device>::template kind_of<Symbol>();
    static_assert(kKind.direction == tables::Direction::event,
                  "this number is an operation: the PLC writes it, the plant reads it");
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
  /// `woken` is called then, once; the last call counts. A time in the past means now; kNever: not at all. It stands
  /// still while the device is disabled.
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
