// Custom behaviors: the functions that a class may define, and its view of a unit (docs/behaviours.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

class Engine;
struct Behaviour;

inline constexpr std::size_t kMaxBehaviourMemory = 4096;

/// A unit as its custom behavior sees it. Valid only during the call of a behavior's function. All members O(1).
class BehaviourView {
 public:
  /// `leads_to`: in a call of `takes` the target of the transition, else kNoState.
  BehaviourView(Engine& engine, std::uint32_t unit, std::uint32_t position,
                std::uint8_t leads_to = tables::kNoState) noexcept
      : engine_(engine), unit_(unit), position_(position), leads_to_(leads_to) {}

  std::uint32_t unit() const noexcept { return unit_; }  ///< its index in PlantTables::units
  std::uint8_t leads_to() const noexcept { return leads_to_; }
  std::uint32_t behaviour() const noexcept;                ///< its index in PlantTables::behaviour_names
  std::span<const Behaviour> behaviours() const noexcept;  ///< those that the plant was made with
  /// The row of a transition in its type's table; null for 0xFFFF, a move without a command.
  const tables::Transition* transition(std::uint16_t number) const noexcept;

  tables::Time now() const noexcept;  ///< the time of this instant
  /// The state in which the unit is settled, or from which it moves. `target()` is the state that it moves to, or
  /// `state()` if it is settled.
  std::uint8_t state() const noexcept;
  std::uint8_t target() const noexcept;
  bool moving() const noexcept;
  /// Whether an operation is on after forces, and armed. Operations and events are numbered within the unit.
  bool operation(std::uint8_t operation) const noexcept;
  bool event(std::uint8_t event) const noexcept;   ///< as the unit itself last set it
  bool input(std::uint32_t input) const noexcept;  ///< a condition of its `inputs`, as published before this round
  /// A numeric symbol of the device, in list order; operations after forces, events as the unit last set them.
  std::uint64_t value(std::uint32_t value) const noexcept;
  /// Whether the link that carries its operations is connected.
  bool quality() const noexcept;

  /// Does nothing if the unit has no such event.
  void set_event(std::uint8_t event, bool on) noexcept;
  /// Does nothing if the symbol is an operation.
  void set_value(std::uint32_t value, std::uint64_t bits) noexcept;
  /// Requests one call of woken() at `time`. A time in the past means now; kNever cancels the request. The remaining
  /// time does not run while the unit is disabled.
  void wake_at(tables::Time time) noexcept;
  /// 64 random bits: draw k of the unit's stream of number 0xFFFF (docs/model.md, "One instant").
  std::uint64_t draw() noexcept;
  /// The time by the model's rule: model_takes() in `takes` (0xFFFF too), model_after() in `after`. A random time is
  /// drawn as the model draws it, and the draw is counted.
  tables::Time model_takes(std::uint16_t transition) noexcept;
  tables::Time model_after(std::uint16_t transition) noexcept;
  /// The memory of the behavior for this unit: all zeros after a reset. It is saved, restored and digested, so Memory
  /// must have no pointers and no padding. Calls std::terminate if Memory is larger than Behaviour::memory_size.
  template <class Memory>
  Memory& memory() noexcept {
    static_assert(sizeof(Memory) <= kMaxBehaviourMemory && alignof(Memory) <= 8);
    static_assert(std::is_trivially_copyable_v<Memory>, "the memory of a behavior is saved and restored byte by byte");
    return *static_cast<Memory*>(memory_bytes(sizeof(Memory)));
  }

 private:
  void* memory_bytes(std::size_t size) noexcept;

  Engine& engine_;
  std::uint32_t unit_;
  std::uint32_t position_;
  std::uint8_t leads_to_;
};

/// The functions of a custom behavior; where one is null the model's rule applies. They are called inside the unit's
/// step: they must be bounded, must not use the heap, locks or system calls, and must depend only on the view (they are
/// called again only when it changes). `takes`, `after` and `wanted` only read; the others may also write and call
/// wake_at().
struct Behaviour {
  std::uint32_t memory_size = 0;  ///< of its memory in bytes, a multiple of 8, up to kMaxBehaviourMemory
  tables::Time (*takes)(BehaviourView&,
                        std::uint16_t transition) noexcept = nullptr;  ///< >= 0; 0xFFFF: a move without a command
  tables::Time (*after)(BehaviourView&, std::uint16_t transition) noexcept = nullptr;  ///< >= 0
  std::uint8_t (*wanted)(BehaviourView&) noexcept = nullptr;  ///< one more wanted state; an invalid state: no wish
  void (*entered)(BehaviourView&, std::uint8_t state) noexcept = nullptr;  ///< after l_enter
  void (*left)(BehaviourView&, std::uint8_t state) noexcept = nullptr;     ///< after l_leave
  void (*woken)(BehaviourView&) noexcept = nullptr;                        ///< at the time given to wake_at()
  void (*started)(BehaviourView&) noexcept = nullptr;                      ///< once, before the first instant
  /// The functions of the I/O model that its class replaces, for messages: values of tables::ModelFunction, added.
  std::uint8_t replaces = 0;
};

}  // namespace symplant::engine
