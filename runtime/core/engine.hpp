// The engine of docs/model.md: one instant after another, each made of rounds, paying for what changes.
//
// Tables must hold no loop of automatic transitions without time; symbol lists alone cannot make one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/core/arena.hpp"
#include "symplant/core/engine_index.hpp"
#include "symplant/core/plant.hpp"
#include "symplant/core/tables.hpp"
#include "symplant/core/wheel.hpp"

namespace symplant::core {

/// The head of the flat block; the arrays of what changes follow it. No pointers: the block may be copied.
struct BlockHead {
  Time now;
  std::uint64_t started;  ///< 0: the first instant, at time 0, is still to run
  Wheel wheel;
};

/// A list in memory of fixed size, large enough for all that it can ever hold.
template <class T>
struct List {
  T* items;
  std::uint32_t size;

  void add(T item) noexcept { items[size++] = item; }
  std::span<const T> view() const noexcept { return {items, size}; }
};

/// Words or slots that were written, each once.
struct DirtySet {
  void take(Arena& arena, std::size_t places) noexcept;
  /// False where it was marked already.
  bool mark(std::uint32_t place) noexcept;
  void clear() noexcept;

  List<std::uint32_t> list;
  std::uint64_t* marks;
};

class Engine {
 public:
  /// Places itself and all its arrays in the memory of `arena`; null where that only counts.
  static Engine* make(const PlantTables& tables, Arena& arena) noexcept;

  void reset() noexcept;
  void write_operation(std::uint32_t bit, bool on) noexcept;
  void write_operation_value(std::uint32_t slot, std::uint64_t value) noexcept;
  void advance_to(Time time, Observer* observer) noexcept;
  Time next_due() const noexcept;

  // --- lies in the flat block
  BlockHead* head;
  UnitState* units;
  std::uint64_t* written_operations;  ///< what the PLC wrote, not yet seen by an instant
  std::uint64_t* operations;          ///< as the last instant saw them
  std::uint64_t* disarmed;            ///< by operation bit
  std::uint64_t* events;
  std::uint64_t* written_values;
  std::uint64_t* operation_values;
  std::uint64_t* event_values;
  DirtySet written_words;
  DirtySet written_slots;

  // --- outside it: gone between instants, or another's business
  DirtySet changed_events;  ///< since the link last asked

 private:
  // What is not set here place() sets.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init,clang-analyzer-optin.cplusplus.UninitializedObject)
  explicit Engine(const PlantTables& tables) noexcept : tables_(tables) {}
  void place(Arena& arena) noexcept;

  // one instant
  void instant(Time time, bool sample, Observer* observer) noexcept;
  void sample_operations() noexcept;
  void queue_due(Time time) noexcept;
  void queue(std::uint32_t unit) noexcept;
  void run_rounds() noexcept;
  void close_instant(Observer* observer) noexcept;

  // one step of one unit in a round (docs/model.md, "One instant")
  void step(std::uint32_t unit) noexcept;
  void step_settled(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept;
  bool fire_automatic(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept;
  void step_moving(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept;
  void leave(std::uint32_t unit, const UnitRow& row, const TypeIndex& type, std::uint8_t target,
             std::uint16_t transition) noexcept;
  void settle(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept;
  void turn_round(std::uint32_t unit, const UnitRow& row, const TypeIndex& type, std::uint16_t transition) noexcept;
  void stand_still(std::uint32_t unit) noexcept;
  void go_on(std::uint32_t unit) noexcept;
  void await_automatic(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept;

  std::uint64_t operations_on(const UnitRow& row, const TypeIndex& type) const noexcept;
  Time takes(const UnitRow& row, std::uint16_t transition) const noexcept;
  Time after(const UnitRow& row, std::uint16_t transition) const noexcept;
  std::uint16_t way_without_command(const TypeIndex& type, std::uint8_t from, std::uint8_t to) const noexcept;
  void time(std::uint32_t unit, Time duration) noexcept;
  void write_events(const UnitRow& row, std::uint64_t bits, bool on) noexcept;
  void write_event_bits(std::uint32_t word, std::uint64_t bits, bool on) noexcept;
  void stepped(std::uint32_t unit) noexcept;

  const PlantTables& tables_;
  EngineIndex index_;
  List<std::uint32_t> current_;  ///< units of this round
  List<std::uint32_t> coming_;   ///< and of the next
  List<std::uint32_t> stepped_;
  DirtySet touched_events_;       ///< words written in this instant
  std::uint64_t* events_before_;  ///< of those, as they stood when it began
  List<WordChange> operation_changes_;
  List<WordChange> event_changes_;
  List<std::uint32_t> slot_changes_;
};

}  // namespace symplant::core
