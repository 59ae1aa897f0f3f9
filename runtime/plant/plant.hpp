// A running plant: the one interface that generated and run-time tables serve alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/engine/behaviour.hpp"
#include "symplant/engine/instant.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {
class Engine;
}

namespace symplant::plant {

/// What one unit is doing.
struct UnitView {
  std::uint8_t state;   ///< settled in, or moving from
  std::uint8_t target;  ///< moving to; `state` where it is settled
  bool moving;
  bool stopped_midway;     ///< moving, but standing still midway (docs/model.md, "A move under way")
  bool disabled;           ///< by another unit
  bool frozen;             ///< found in an instantaneous loop
  tables::Time remaining;  ///< of the move, ns
  double progress;         ///< of the move, 0 to 1; 0 where it is settled
};

/// A plant of the tables given, in the memory given (memory_size() bytes, aligned for any type).
///
/// Every member is noexcept and allocates, locks and calls nothing (but observers and behaviours); a plant belongs to
/// one thread at a time, any number of plants may live in a process. Tables, behaviours and memory must outlive it.
///
/// Operations are sampled: what is written counts in the instant at the time that advance_to() is next called for.
/// Everything else that acts from outside (set_input, set_state, force, release) acts at now(), in the next instant
/// run there; advance_before() brings the plant to a time without running its instant.
class Plant {
 public:
  /// Bytes that a plant of these tables and behaviours needs. O(tables).
  static std::size_t memory_size(const tables::PlantTables& tables,
                                 std::span<const engine::Behaviour> behaviours = {}) noexcept;

  /// `behaviours`: the user's code by its place in PlantTables::behaviour_names; where there is none, or an empty one,
  /// the model's own rules serve those units.
  /// Ends the program where the memory is too small.
  Plant(const tables::PlantTables& tables, std::span<std::byte> memory,
        std::span<const engine::Behaviour> behaviours = {}) noexcept;
  Plant(const tables::PlantTables&&, std::span<std::byte>,
        std::span<const engine::Behaviour> = {}) = delete;  // would not outlive it
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;

  const tables::PlantTables& tables() const noexcept { return tables_; }
  /// What this plant is: equal for generated and run-time tables of one description. Worked out once; O(1).
  std::uint64_t model_hash() const noexcept;

  /// Back to time 0: every unit in its initial state, every operation off, every force released. The first instant, at
  /// 0, is still to run. `seed` is that of all random times. `cycle` 0 is virtual time; else the length of the cycle
  /// in ns in which a PLC samples, and events that are on for less are findings. Cost: the size of the plant.
  void reset(std::uint64_t seed = 0, tables::Time cycle = 0) noexcept;

  /// Writes a BOOL operation by its bit in the plane, as a PLC does; seen by the next instant that samples. O(1).
  void set_operation(std::uint32_t bit, bool on) noexcept;
  /// Writes those operations of a word of the plane that are set in `mask`, as they are in `bits`. O(1).
  void set_operations(std::uint32_t word, std::uint64_t mask, std::uint64_t bits) noexcept;
  /// Writes a numeric operation by its slot; the value is a two's complement integer or the bits of a double. O(1).
  void set_operation_value(std::uint32_t slot, std::uint64_t value) noexcept;

  /// Sets an event that no unit moves, as its source in the plant would: by symbol, BOOL as 0 or 1. False, and nothing
  /// done, where the symbol is an operation, is moved by a unit, or follows one that is. O(symbols on the address).
  bool set_input(std::uint32_t symbol, std::uint64_t value) noexcept;
  /// Holds a symbol, and all on its address, at a value (taken as it is, beyond its type's range too) until it is
  /// released. What is written or made meanwhile is kept and shows again then. O(symbols on the address).
  void force(std::uint32_t symbol, std::uint64_t value) noexcept;
  void release(std::uint32_t symbol) noexcept;
  bool is_forced(std::uint32_t symbol) const noexcept;
  /// Puts a unit into a state, as a person moves it: a move under way ends, the old state is left, the new one is
  /// entered, also where it is the same; a disabled or frozen unit stays so. Nothing is done where the unit has no such
  /// state. O(1) beside what it changes.
  void set_state(std::uint32_t unit, std::uint8_t state) noexcept;
  /// What behaviours are told of the link that carries their operations; well after a reset. O(devices with a
  /// behaviour).
  void set_quality(bool well) noexcept;
  /// What one device's behaviour is told, by its place in PlantTables::behaviour_units. O(1).
  void set_quality(std::uint32_t behaviour, bool well) noexcept;

  /// Runs every instant that is due before `time` on the operations as they were, then the one at `time` with what
  /// was written since the last call. Called again for the same time, it runs a further instant only if something
  /// was written or done. A time before now() is taken as now(). Costs what happens, not what exists.
  void advance_to(tables::Time time, engine::Observer* observer = nullptr) noexcept;
  /// Runs every instant that is due before `time` and stands there, the instant at `time` still to run.
  void advance_before(tables::Time time, engine::Observer* observer = nullptr) noexcept;

  tables::Time now() const noexcept;
  /// When something will happen by itself: now() before the first instant, kNever where nothing will. O(units that
  /// become due within the same stretch of time: 256 ns, 65 us, 16.7 ms, ... as it is away).
  tables::Time next_due() const noexcept;

  // All read-outs are of the effective side, after forces.
  bool operation(std::uint32_t bit) const noexcept;  ///< as the last instant saw it
  bool event(std::uint32_t bit) const noexcept;
  std::uint64_t operation_value(std::uint32_t slot) const noexcept;
  std::uint64_t event_value(std::uint32_t slot) const noexcept;
  std::span<const std::uint64_t> operations() const noexcept;  ///< the whole bit plane, as the last instant saw it
  std::span<const std::uint64_t> events() const noexcept;

  /// The words of events() that changed since forget_changed_events(), each once, in no order; all after a reset or a
  /// restore.
  std::span<const std::uint32_t> changed_events() const noexcept;
  /// The slots of event_value() likewise.
  std::span<const std::uint32_t> changed_event_values() const noexcept;
  void forget_changed_events() noexcept;

  UnitView unit(std::uint32_t unit) const noexcept;
  /// By bit of operations(): on, but without effect until it has been off (docs/model.md, "Transitions"). What is off
  /// there is armed.
  std::span<const std::uint64_t> disarmed() const noexcept;

  /// Whether a requirement waits for what it expects. O(1).
  bool is_pending(std::uint32_t requirement) const noexcept;

  /// Takes the oldest finding out of the ring; false where there is none.
  bool take_finding(tables::Finding& finding) noexcept;
  /// Findings that a full ring did not take, since reset().
  std::uint64_t lost_findings() const noexcept;

  /// All that changes in a plant, in one block without pointers: save is a copy of it, to be restored into any plant of
  /// equal model_hash by the same build of the runtime, unaltered: its bytes are trusted. Findings not yet taken and
  /// changes not yet forgotten are not part of it.
  std::span<const std::byte> save() const noexcept;
  /// False, and nothing done, where the block is another model's or none. O(plant), at memory speed.
  bool restore(std::span<const std::byte> block) noexcept;
  /// Digest of the logical state, whatever the history (docs/engine.md tells its fields). O(plant).
  std::uint64_t state_hash() const noexcept;

 private:
  const tables::PlantTables& tables_;
  engine::Engine* engine_;
};

}  // namespace symplant::plant
