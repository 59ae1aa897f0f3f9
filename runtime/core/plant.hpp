// A running plant: the one interface that generated and run-time tables serve alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/core/tables.hpp"
#include "symplant/core/time.hpp"

namespace symplant::core {

class Engine;

/// A 64-bit word of a bit plane that an instant changed, and which of its bits.
struct WordChange {
  std::uint32_t word;
  std::uint64_t bits;
};

/// The net effect of all that happened at one time. Valid only while the observer is called.
struct Instant {
  Time time;
  std::span<const std::uint32_t> units;    ///< that made a step, in no order
  std::span<const WordChange> operations;  ///< by word, in no order
  std::span<const WordChange> events;
  std::span<const std::uint32_t> operation_slots;  ///< values that changed
  std::span<const std::uint32_t> event_slots;
};

/// Is told of every instant in which anything changed. Called inside advance_to: bounded and noexcept.
class Observer {
 public:
  virtual void instant(const Instant& instant) noexcept = 0;

 protected:
  ~Observer() = default;
};

/// What one unit is doing.
struct UnitView {
  std::uint8_t state;   ///< settled in, or moving from
  std::uint8_t target;  ///< moving to; `state` where it is settled
  bool moving;
  Time remaining;   ///< of the move, ns
  double progress;  ///< of the move, 0 to 1; 0 where it is settled
};

/// A plant of the tables given, in the memory given (memory_size() bytes, aligned for any type).
///
/// Every member is noexcept and allocates, locks and calls nothing; a plant belongs to one thread at a time, any
/// number of plants may live in a process. Tables and memory must outlive it.
class Plant {
 public:
  static std::size_t memory_size(const PlantTables& tables) noexcept;

  Plant(const PlantTables& tables, std::span<std::byte> memory) noexcept;
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;

  const PlantTables& tables() const noexcept { return tables_; }

  /// Back to time 0: every unit in its initial state, every operation off. The first instant, at 0, is still to run.
  /// Cost: the size of the plant.
  void reset() noexcept;

  /// Writes a BOOL operation by its bit in the plane, as a PLC does; seen by the next instant. O(1).
  void set_operation(std::uint32_t bit, bool on) noexcept;
  /// Writes a numeric operation by its slot; the value is a two's complement integer or the bits of a double. O(1).
  void set_operation_value(std::uint32_t slot, std::uint64_t value) noexcept;

  /// Runs every instant that is due before `time` on the operations as they were, then the one at `time` with what
  /// was written since the last call. Called again for the same time, it runs a further instant only if something
  /// was written. A time before now() is taken as now(). Costs what happens, not what exists.
  void advance_to(Time time, Observer* observer = nullptr) noexcept;

  Time now() const noexcept;
  /// When something will happen by itself: now() before the first instant, kNever where nothing will.
  Time next_due() noexcept;

  bool operation(std::uint32_t bit) const noexcept;  ///< as the last instant saw it
  bool event(std::uint32_t bit) const noexcept;
  std::uint64_t operation_value(std::uint32_t slot) const noexcept;
  std::uint64_t event_value(std::uint32_t slot) const noexcept;
  std::span<const std::uint64_t> operations() const noexcept;  ///< the whole bit plane, as the last instant saw it
  std::span<const std::uint64_t> events() const noexcept;

  /// The words of events() that changed since forget_changed_events(), each once, in no order.
  std::span<const std::uint32_t> changed_events() const noexcept;
  void forget_changed_events() noexcept;

  UnitView unit(std::uint32_t unit) const noexcept;

 private:
  friend class Engine;
  const PlantTables& tables_;
  Engine* engine_;
};

}  // namespace symplant::core
