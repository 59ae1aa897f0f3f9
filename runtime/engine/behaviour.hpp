// The user's own code for devices: what a derived class may replace, and what it sees (docs/model.md, "Behaviours").
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

/// A unit as its behaviour sees it, while one of its functions is called. Valid only then. All members O(1).
class BehaviourView {
 public:
  /// `way_to`: where the way leads that `takes` is asked for, kNoState elsewhere.
  BehaviourView(Engine& engine, std::uint32_t unit, std::uint32_t position,
                std::uint8_t leads_to = tables::kNoState) noexcept
      : engine_(engine), unit_(unit), position_(position), leads_to_(leads_to) {}

  std::uint32_t unit() const noexcept { return unit_; }  ///< its place in PlantTables::units
  std::uint8_t leads_to() const noexcept { return leads_to_; }
  std::uint32_t behaviour() const noexcept;                ///< its place in PlantTables::behaviour_names
  std::span<const Behaviour> behaviours() const noexcept;  ///< those that the plant was made of
  /// The row of a transition of its table; null for 0xFFFF, a way without a command.
  const tables::Transition* transition(std::uint16_t number) const noexcept;

  tables::Time now() const noexcept;  ///< of this instant
  /// Settled in, or moving from; `target()` is where to, the same where it is settled.
  std::uint8_t state() const noexcept;
  std::uint8_t target() const noexcept;
  bool moving() const noexcept;
  /// On: its level after forces, and armed. `operation` counts within the unit, like `event`.
  bool operation(std::uint8_t operation) const noexcept;
  bool event(std::uint8_t event) const noexcept;   ///< as the unit itself last set it
  bool input(std::uint32_t input) const noexcept;  ///< a condition of its `inputs`, in their order, by the snapshot
  /// Numeric symbols of the device, in list order; operations after forces, events as the unit last set them.
  std::uint64_t value(std::uint32_t value) const noexcept;
  /// Whether the link that carries its operations is well.
  bool quality() const noexcept;

  /// Does nothing where the unit has no such event.
  void set_event(std::uint8_t event, bool on) noexcept;
  /// Does nothing where the symbol is an operation.
  void set_value(std::uint32_t value, std::uint64_t bits) noexcept;
  /// woken() is called then, once; a time in the past means now. kNever: not at all. Stands still while disabled.
  void wake_at(tables::Time time) noexcept;
  /// 64 random bits: draw k of the unit's stream of number 0xFFFF (docs/model.md, "Random times").
  std::uint64_t draw() noexcept;
  /// What the model's own rule says, in `takes` (also of 0xFFFF) and in `after`. A random time counts as the draw that
  /// the model would have made.
  tables::Time model_takes(std::uint16_t transition) noexcept;
  tables::Time model_after(std::uint16_t transition) noexcept;
  /// The behaviour's own memory, at most as large as Behaviour::memory_size (a larger one ends the program): zeros
  /// after a reset; saved, restored, digested, so without pointers and padding.
  template <class Memory>
  Memory& memory() noexcept {
    static_assert(sizeof(Memory) <= kMaxBehaviourMemory && alignof(Memory) <= 8);
    static_assert(std::is_trivially_copyable_v<Memory>, "a behaviour's memory is saved and restored byte by byte");
    return *static_cast<Memory*>(memory_bytes(sizeof(Memory)));
  }

 private:
  void* memory_bytes(std::size_t size) noexcept;

  Engine& engine_;
  std::uint32_t unit_;
  std::uint32_t position_;
  std::uint8_t leads_to_;
};

/// What a behaviour defines, as plain functions; null: the model's own rule. Called inside the unit's step: bounded,
/// without heap, lock or system call, and by what the view shows alone (called again only when that changes). `takes`,
/// `after` and `wanted` only look; the others may write, and ask to be woken.
struct Behaviour {
  std::uint32_t memory_size = 0;  ///< of its memory, a multiple of 8, up to kMaxBehaviourMemory
  tables::Time (*takes)(BehaviourView&,
                        std::uint16_t transition) noexcept = nullptr;  ///< >= 0; 0xFFFF: a spring's own way
  tables::Time (*after)(BehaviourView&, std::uint16_t transition) noexcept = nullptr;  ///< >= 0
  std::uint8_t (*wanted)(BehaviourView&) noexcept = nullptr;  ///< one more wanted state; what is none of it: none
  void (*entered)(BehaviourView&, std::uint8_t state) noexcept = nullptr;  ///< after l_enter
  void (*left)(BehaviourView&, std::uint8_t state) noexcept = nullptr;     ///< after l_leave
  void (*woken)(BehaviourView&) noexcept = nullptr;                        ///< at the time that it asked for
};

}  // namespace symplant::engine
