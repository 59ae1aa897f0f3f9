// A running plant: one interface for generated tables and for tables made at run time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/engine/behaviour.hpp"
#include "symplant/engine/bit_words.hpp"
#include "symplant/engine/instant.hpp"
#include "symplant/engine/malfunction/active_malfunction.hpp"
#include "symplant/engine/value/output_range.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {
class Engine;
}

namespace symplant::plant {

/// What one unit is doing.
struct UnitView {
  std::uint8_t state;   ///< the state in which it is settled, or from which it moves
  std::uint8_t target;  ///< the state to which it moves; `state` if it is settled
  bool moving;
  bool stopped_midway;     ///< moving, but stopped midway (docs/model.md, "Commands during a move")
  bool disabled;           ///< by another unit, or stuck by a malfunction
  bool frozen;             ///< found in an instantaneous loop
  tables::Time remaining;  ///< remaining travel time, ns; 0 if it is settled
  tables::Time whole;      ///< travel time of the whole move, ns; 0 if it is settled
  double progress;         ///< of the move, 0 to 1; 0 if it is settled
};

/// A part of the material flow.
struct PartView {
  std::uint64_t number;  ///< from 1, in the order in which they were made
  std::uint32_t kind;
  std::int64_t x;       ///< on a track: its front, in um, rounded down; else 0
  std::int64_t speed;   ///< on a track: um/s, < 0: backward; else 0
  std::uint32_t drive;  ///< of the track: the one that moves it; 0 elsewhere
  tables::Time since;   ///< when it came to its location
};

/// How a part on a track moves: at plant time t its front is at x + v * (t - now).
struct PartMotion {
  std::int64_t x;  ///< um, rounded down
  std::int32_t v;  ///< um/s; < 0: backward
};

/// What a malfunction does.
struct MalfunctionView {
  bool active;
  tables::Time since;     ///< when it started; 0 if it is not active
  tables::Time next_due;  ///< when it changes by itself, kNever: only by a condition or from outside
};

/// What a transfer of parts does.
struct TransferView {
  bool blocked;            ///< the finding `part blocked` is true
  bool frozen;             ///< found in an instantaneous loop
  bool spent;              ///< `once`: it has moved the part that the beginning of its condition allowed
  std::uint64_t part;      ///< the part that it would move; 0: none
  std::uint64_t obstacle;  ///< a part that leaves no room for it; 0: there is room, or nothing to move
};

/// What a source of parts does.
struct SourceView {
  tables::Time due;    ///< when it makes its next part, or has been due since; kNever: it makes no further part
  std::uint64_t made;  ///< the number of parts that it has made
};

/// A plant of the given tables in the given memory (memory_size() bytes, aligned for any type).
///
/// Every member is noexcept and uses no heap, no lock and no system call; it calls only observers and behaviors. Only
/// one thread at a time may use a plant; a process may have any number of plants. Tables, behaviors and memory must
/// outlive the plant.
///
/// Operations are sampled: a write takes effect in the instant at the time of the next advance_to(). All other actions
/// from outside (set_input, set_state, force, release, start_malfunction) take effect at now(), in the next instant
/// that runs at that time. advance_before() brings the plant to a time without running its instant.
class Plant {
 public:
  /// Bytes that a plant of these tables and behaviors needs. O(tables).
  static std::size_t memory_size(const tables::PlantTables& tables,
                                 std::span<const engine::Behaviour> behaviours = {}) noexcept;

  /// `behaviours`: the custom behaviors, in the order of PlantTables::behaviour_names. Units whose behavior is missing
  /// or empty follow the model's rules. Calls std::terminate if the memory is too small.
  Plant(const tables::PlantTables& tables, std::span<std::byte> memory,
        std::span<const engine::Behaviour> behaviours = {}) noexcept;
  Plant(const tables::PlantTables&&, std::span<std::byte>,
        std::span<const engine::Behaviour> = {}) = delete;  // tables must outlive it
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;

  const tables::PlantTables& tables() const noexcept { return tables_; }
  /// Identity of the model: equal for generated and run-time tables of one description. Computed once; O(1).
  std::uint64_t model_hash() const noexcept;

  /// Resets to time 0: every unit in its initial state, every operation off (an inverted one has its bit on), every
  /// force released. The first instant, at 0, has not run yet. All random times are drawn from `seed`. `cycle` 0 means
  /// virtual time. Otherwise `cycle` is the time in ns between two samples of the PLC, and an event that is on for less
  /// is a finding. O(plant).
  void reset(std::uint64_t seed = 0, tables::Time cycle = 0) noexcept;

  /// Writes a BOOL operation by its bit in the plane, as a PLC does; the next instant that samples reads it. O(1).
  void set_operation(std::uint32_t bit, bool on) noexcept;
  /// Writes several operations in one word of the plane: those that are set in `mask` get their values from `bits`.
  /// O(1).
  void set_operations(std::uint32_t word, std::uint64_t mask, std::uint64_t bits) noexcept;
  /// Writes a numeric operation by its slot; the value is a two's complement integer or the bits of a double. O(1).
  void set_operation_value(std::uint32_t slot, std::uint64_t value) noexcept;
  /// The numeric operation as written last, before forces, also if no instant has read it yet. O(1).
  std::uint64_t written_operation_value(std::uint32_t slot) const noexcept;

  /// Sets an event that no unit drives, as a sensor would. `value` is 0 or 1 for a BOOL symbol. Returns false and does
  /// nothing if the symbol is an operation, or if a unit drives the symbol or another event on its address. O(symbols
  /// on the address).
  bool set_input(std::uint32_t symbol, std::uint64_t value) noexcept;
  /// Holds a symbol, and all others on its address, at a value until it is released. The value is not checked against
  /// the type's range. Values written meanwhile are kept and take effect on release. O(symbols on the address).
  void force(std::uint32_t symbol, std::uint64_t value) noexcept;
  void release(std::uint32_t symbol) noexcept;
  bool is_forced(std::uint32_t symbol) const noexcept;
  /// Puts a unit into a state, as if moved by hand: a current move ends, the old state is left and the new one entered,
  /// even if they are the same. A disabled or frozen unit stays so. Does nothing if the unit has no such state. O(1)
  /// plus the cost of the changes.
  void set_state(std::uint32_t unit, std::uint8_t state) noexcept;
  /// Makes a part at a location, by hand. `at`: the position of its middle on a track, in um, or tables::kWhole.
  /// Returns false and does nothing if there is no room. O(parts at the location).
  bool put(tables::PartLocation to, std::uint32_t kind) noexcept;
  /// Removes the part that a transfer would take from there, by hand. Returns false and does nothing if there is none.
  /// O(parts at the location).
  bool take(tables::PartLocation from) noexcept;
  /// Sets the output of a value by hand, limited to its range. Returns false and does nothing unless it is a parameter,
  /// an integral, a lag or a ramp, and the number finite. O(readers of the value).
  bool set_value(std::uint32_t value, double number) noexcept;
  /// Starts or ends a malfunction; tables::MalfunctionNumbers numbers them. `by`: scenario or hand, for the trace. To
  /// start one that is active or in an instantaneous loop, and to end one that is not active, does nothing and returns
  /// true. Returns false and does nothing if there is no such malfunction, or too many ordinary ones are active.
  /// O(written malfunctions, and what it affects).
  bool start_malfunction(std::uint32_t number,
                         engine::MalfunctionChange::By by = engine::MalfunctionChange::By::hand) noexcept;
  bool stop_malfunction(std::uint32_t number,
                        engine::MalfunctionChange::By by = engine::MalfunctionChange::By::hand) noexcept;
  /// Sets for all custom behaviors whether the link that carries their operations is connected (quality()); true after
  /// a reset. O(devices with a behavior).
  void set_quality(bool well) noexcept;
  /// The same for one device, by its index in PlantTables::behaviour_units. O(1).
  void set_quality(std::uint32_t behaviour, bool well) noexcept;

  /// Makes the events of the initial states visible before the first instant, at time 0 and without a step of any unit.
  /// It is for a plant that must not move yet. Does nothing after the first instant. O(plant).
  void show(engine::Observer* observer = nullptr) noexcept;
  /// Runs every instant that is due before `time` with the operations as sampled last, then the one at `time` with
  /// the operations written since. A second call for the same time runs another instant only if an operation was
  /// written or another action happened. A time before now() means now(). The cost depends on the changes, not on the
  /// size of the plant.
  void advance_to(tables::Time time, engine::Observer* observer = nullptr) noexcept;
  /// Runs every instant that is due before `time`, then sets now() to `time` without running the instant at `time`.
  void advance_before(tables::Time time, engine::Observer* observer = nullptr) noexcept;

  tables::Time now() const noexcept;
  /// The time of the next instant without an outside action: now() before the first instant, kNever if nothing is due.
  /// O(units in one bucket of the wheel). The bucket is wider for a time that is farther away: 256 ns, 65 us, 16.7 ms,
  /// ...
  tables::Time next_due() const noexcept;

  // All values read here are after forces.
  bool operation(std::uint32_t bit) const noexcept;  ///< as sampled by the last instant
  bool event(std::uint32_t bit) const noexcept;
  std::uint64_t operation_value(std::uint32_t slot) const noexcept;
  std::uint64_t event_value(std::uint32_t slot) const noexcept;
  engine::BitWords operations() const noexcept;  ///< the whole bit plane, as sampled by the last instant
  engine::BitWords events() const noexcept;

  /// The words of events() that changed since forget_changed_events(), each once, in no order; also a word that changed
  /// and changed back. All words after a reset or a restore.
  std::span<const std::uint32_t> changed_events() const noexcept;
  /// The slots of event_value() that changed since forget_changed_events(), each once, in no order; all after a reset
  /// or a restore.
  std::span<const std::uint32_t> changed_event_values() const noexcept;
  /// In real time: the bits of a word of events() that changed in more than one instant since forget_changed_events().
  std::uint64_t pulsed_events(std::uint32_t word) const noexcept;
  /// To be called at the end of each cycle in real time. After a cycle in which plant time did not advance, the events
  /// that are on no longer count as *too short*, since the PLC could read them. O(changes).
  void forget_changed_events() noexcept;
  /// Sets the events, as a mask over events(), that a link shows to its PLC on request. Such a link knows what its PLC
  /// has read, so in real time these events are never *too short* within a cycle. Kept by reset() and restore(). To be
  /// called only between instants.
  void show_on_request(std::span<const std::uint64_t> events) noexcept;

  /// An output of a value (ValueRow::output). O(1).
  double output(std::uint32_t output) const noexcept;
  /// After restore(): an observer gets all outputs at the next time at which a trace shows them, as after a reset.
  /// O(outputs).
  void show_outputs() noexcept;
  /// From now on the least and the greatest number of each output are noted: a few instructions for each number that
  /// changes. O(outputs).
  void watch_outputs() noexcept;
  /// The range of an output since watch_outputs(), which must have been called. O(1).
  engine::OutputRange output_range(std::uint32_t output) const noexcept;

  UnitView unit(std::uint32_t unit) const noexcept;
  /// How long the cause of a transition from the unit's state must still hold before the unit leaves; kNever if the
  /// cause does not hold, or need not hold for a time. O(1).
  tables::Time after_left(std::uint32_t unit, std::uint16_t transition) const noexcept;
  /// Mask over operations(): a set bit is disarmed, without effect until the operation has been off (docs/model.md,
  /// "A transition"). The other operations are armed.
  std::span<const std::uint64_t> disarmed() const noexcept;

  /// The number of parts at a location. O(1).
  std::uint32_t parts(std::uint32_t location) const noexcept;
  /// The sum of the weights of the parts at a location. O(parts).
  double weight(std::uint32_t location) const noexcept;
  /// A part at a location: `index` 0 is the front-most on a track, and the one that came first in a place. O(1).
  PartView part(std::uint32_t location, std::uint32_t index) const noexcept;
  /// The motion of a part on a track, from now on. O(1).
  PartMotion motion(std::uint32_t track, std::uint32_t index) const noexcept;
  /// The parts made as a kind since the reset, those that left the plant as that kind, and those present. Work changes
  /// the kind of parts, so that present is not made - gone. O(1), O(parts) for the present ones.
  std::uint64_t parts_made(std::uint32_t kind) const noexcept;
  std::uint64_t parts_gone(std::uint32_t kind) const noexcept;
  std::uint64_t parts_present(std::uint32_t kind) const noexcept;
  /// Whether a track was found in an instantaneous loop: its parts do not move. O(1).
  bool is_frozen_track(std::uint32_t track) const noexcept;
  /// O(parts at its locations).
  TransferView transfer(std::uint32_t transfer) const noexcept;
  SourceView source(std::uint32_t source) const noexcept;  ///< O(1)

  tables::MalfunctionNumbers malfunction_numbers() const noexcept { return tables::MalfunctionNumbers(tables_); }
  /// O(active malfunctions).
  MalfunctionView malfunction(std::uint32_t number) const noexcept;
  /// The active malfunctions, in the order in which they started. O(1).
  std::span<const engine::ActiveMalfunction> active_malfunctions() const noexcept;
  /// Whether an active malfunction disables a unit. O(active malfunctions).
  bool is_stuck(std::uint32_t unit) const noexcept;
  /// The active malfunction that gives a symbol its value or lets it flicker, also if the user forces the symbol; of
  /// several the one that started last. kNone: none. O(active malfunctions and their symbols).
  std::uint32_t malfunction_of_symbol(std::uint32_t symbol) const noexcept;
  /// Whether an active malfunction cuts the link of a controller, so that it must exchange nothing. O(active
  /// malfunctions).
  bool is_cut(std::uint32_t controller) const noexcept;

  /// Whether a requirement is waiting for its expected condition. O(1).
  bool is_pending(std::uint32_t requirement) const noexcept;

  /// Removes the oldest finding from the ring; false if the ring is empty.
  bool take_finding(tables::Finding& finding) noexcept;
  /// Number of findings lost since reset() because the ring was full.
  std::uint64_t lost_findings() const noexcept;

  /// The whole changing state, in one block without pointers. A copy of it can be restored into any plant of equal
  /// model_hash by the same build of the runtime. It must be unaltered: restore() trusts its bytes. Findings not yet
  /// taken and changes not yet forgotten are not part of it.
  std::span<const std::byte> save() const noexcept;
  /// Restores a copy of save(), except for the cycle, which remains that of the last reset(). Returns false and does
  /// nothing if the block is of another model or invalid. O(plant).
  bool restore(std::span<const std::byte> block) noexcept;
  /// Digest of the logical state, independent of its history (docs/engine.md lists its fields). O(plant).
  std::uint64_t state_hash() const noexcept;

 private:
  const tables::PlantTables& tables_;
  engine::Engine* engine_;
};

}  // namespace symplant::plant
