// The engine of docs/model.md: runs instants, each in rounds; its cost depends on what changes.
// docs/engine.md explains rounds, the wheel and the flat block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/behaviour.hpp"
#include "symplant/engine/bit_words.hpp"
#include "symplant/engine/block.hpp"
#include "symplant/engine/dirty_set.hpp"
#include "symplant/engine/engine_index.hpp"
#include "symplant/engine/event_changes.hpp"
#include "symplant/engine/finding_ring.hpp"
#include "symplant/engine/instant.hpp"
#include "symplant/engine/malfunction/malfunctions.hpp"
#include "symplant/engine/mark_range.hpp"
#include "symplant/engine/material/flow.hpp"
#include "symplant/engine/planes.hpp"
#include "symplant/engine/pulses.hpp"
#include "symplant/engine/short_events.hpp"
#include "symplant/engine/unit_state.hpp"
#include "symplant/engine/value/values.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

class Engine {
  friend class BehaviourView;  // what a custom behavior sees and does is part of the engine
  friend class Flow;           // the material flow is part of the engine
  friend class Malfunctions;   // malfunctions are part of the engine
  friend class Values;         // values are part of the engine

 public:
  /// Constructs an engine and all its arrays in the memory of `arena`; null if the arena only counts.
  static Engine* make(const tables::PlantTables& tables, std::span<const Behaviour> behaviours, Arena& arena) noexcept;

  void reset(std::uint64_t seed, tables::Time cycle) noexcept;
  void show(Observer* observer) noexcept;
  void advance_to(tables::Time time, Observer* observer) noexcept;
  void advance_before(tables::Time time, Observer* observer) noexcept;
  tables::Time next_due() const noexcept;

  // Actions from outside (engine_acts.cpp).
  void write_operation(std::uint32_t bit, bool on) noexcept;
  void write_operations(std::uint32_t word, std::uint64_t mask, std::uint64_t bits) noexcept;
  void write_operation_value(std::uint32_t slot, std::uint64_t value) noexcept;
  bool set_input(std::uint32_t symbol, std::uint64_t value) noexcept;
  void force(std::uint32_t symbol, bool forced, std::uint64_t value) noexcept;
  void set_state(std::uint32_t unit, std::uint8_t state) noexcept;
  void set_quality(std::size_t behaviour, bool well) noexcept;
  bool put(const tables::PartLocation& to, std::uint32_t kind) noexcept;
  bool take(const tables::PartLocation& from) noexcept;
  bool set_value(std::uint32_t value, double number) noexcept;
  void watch_outputs() noexcept { values_.watch(); }
  void show_outputs() noexcept { values_.show_from_here(); }
  bool start_malfunction(std::uint32_t number, MalfunctionChange::By by) noexcept {
    return malfunctions_.start(number, by);
  }
  bool stop_malfunction(std::uint32_t number, MalfunctionChange::By by) noexcept {
    return malfunctions_.stop(number, by);
  }
  bool restore(std::span<const std::byte> block) noexcept;

  // For Plant, whose comments define these functions. All symbols are after forces.
  std::uint64_t model_hash() const noexcept { return head_->model; }
  std::uint64_t state_hash() const noexcept;
  tables::Time now() const noexcept { return head_->now; }
  BitWords operations() const noexcept { return BitWords(operation_plane_); }
  BitWords events() const noexcept { return BitWords(event_plane_); }
  std::span<const std::uint64_t> disarmed() const noexcept { return {disarmed_, tables_.operation_bits / 64}; }
  std::uint64_t operation_value(std::uint32_t slot) const noexcept { return operation_values_.values[slot]; }
  std::uint64_t written_operation_value(std::uint32_t slot) const noexcept { return written_values_[slot]; }
  std::uint64_t event_value(std::uint32_t slot) const noexcept { return event_values_.values[slot]; }
  bool is_forced(std::uint32_t symbol) const noexcept;
  bool is_pending(std::uint32_t requirement) const noexcept { return monitors_[requirement].running != 0; }
  const EventChanges& changed_events() const noexcept { return event_changes_; }
  const DirtySet& changed_event_values() const noexcept { return changed_event_slots_; }
  std::uint64_t pulsed_events(std::uint32_t word) const noexcept { return pulses_.of_word(word); }
  void forget_changed_events() noexcept;
  void show_on_request(std::span<const std::uint64_t> events) noexcept;
  bool take_finding(tables::Finding& finding) noexcept { return findings_.pop(finding); }
  std::uint64_t lost_findings() const noexcept { return findings_.lost(); }
  std::span<const std::byte> save() const noexcept { return {reinterpret_cast<const std::byte*>(head_), block_size_}; }
  const UnitState& unit(std::uint32_t unit) const noexcept { return units_[unit]; }
  const Flow& flow() const noexcept { return flow_; }
  const Malfunctions& malfunctions() const noexcept { return malfunctions_; }
  const Values& values() const noexcept { return values_; }
  /// Remaining travel time of a moving unit, ns; kNever if the move never ends.
  tables::Time remaining(std::uint32_t unit) const noexcept {
    const UnitState& state = units_[unit];
    return (state.flags & (kMidway | kHalted)) != 0 || state.due == tables::kNever ? state.due : state.due - head_->now;
  }
  /// Total travel time of a moving unit, ns; 0 if it is settled.
  tables::Time whole(std::uint32_t unit) const noexcept;
  tables::Time after_left(std::uint32_t unit, std::uint16_t transition) const noexcept;

 private:
  // position() sets all other members.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init,clang-analyzer-optin.cplusplus.UninitializedObject)
  Engine(const tables::PlantTables& plant_tables, std::span<const Behaviour> code) noexcept
      : tables_(plant_tables), behaviours_(code), flow_(*this), malfunctions_(*this), values_(*this) {}
  void position(Arena& arena) noexcept;
  void position_names(Arena& arena) noexcept;
  void place_block(Arena& arena) noexcept;
  void reset_values() noexcept;
  void reset_levels() noexcept;
  void reset_conditions() noexcept;
  void start_behaviours() noexcept;

  // actions from outside (engine_acts.cpp)
  void wait_for_sample(std::uint32_t word) noexcept;
  void write_shared(std::uint32_t bit, bool on) noexcept;
  void write_shared(std::uint32_t word, std::uint64_t mask, std::uint64_t bits) noexcept;
  void override_symbol(std::uint32_t symbol, const Override& to) noexcept;
  void requeue() noexcept;
  void see_events() noexcept;
  void touch_readers(tables::Direction direction, std::uint32_t slot) noexcept;

  // for custom behaviors (engine_behaviour.cpp)
  void make_event_bits(std::uint32_t word, std::uint64_t on, std::uint64_t off) noexcept;
  void make_followers(std::uint32_t word, std::uint64_t on, std::uint64_t off) noexcept;
  void make_event_value(std::uint32_t slot, std::uint64_t value) noexcept;
  void wake_at(std::uint32_t behaviour, tables::Time time) noexcept;
  /// `transition` may be kNoTransition: a move to `target` without a command.
  tables::Time takes_by_model(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                              std::uint8_t target, std::uint16_t transition) noexcept;
  tables::Time after_by_model(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                              std::uint16_t transition) noexcept;
  /// Size of the memory of a unit's custom behavior, in bytes.
  std::uint32_t memory_of(std::size_t behaviour) const noexcept;
  std::uint64_t name_hash(std::uint32_t unit) const noexcept { return name_hashes_[index_.general.position_of(unit)]; }
  GeneralState& general_state(std::uint32_t unit) const noexcept;
  const GeneralRow& general_row(std::uint32_t unit) const noexcept { return index_.general.row_of(unit); }
  void switch_events(const tables::UnitRow& row, const tables::EventMasks& masks) noexcept;
  bool truth(std::uint32_t condition) const noexcept { return (condition_states_[condition] & kTruth) != 0; }
  std::uint64_t operations_on(const tables::UnitRow& row, const TypeIndex& type) const noexcept;

  // the digest of the state (state_hash.cpp)
  void hash_move(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept;
  void hash_transitions(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept;
  void hash_symbols(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept;
  void hash_behaviour(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept;
  void hash_free_symbol(tables::Fnv1a64& hash, const tables::SymbolRow& symbol) const noexcept;

  // one instant (engine_advance.cpp)
  void instant(tables::Time time, bool due, bool sample, Observer* observer) noexcept;
  void start() noexcept;
  bool only_fast_steps() const noexcept;
  void queue_due(tables::Time time, bool fast) noexcept;
  void queue_other(std::uint32_t entry) noexcept;
  void advance_waiting(tables::Time target, bool at_target, Observer* observer) noexcept;
  tables::Time next_instant(tables::Time limit) noexcept;
  void waiting_instant(tables::Time time, bool sample, Observer* observer) noexcept;

  // the fast path (engine_fast.cpp)
  bool depart_fast(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type, std::uint64_t on) noexcept;
  bool arrive_fast(std::uint32_t unit) noexcept;
  void switch_fast(const tables::UnitRow& row, const tables::EventMasks& masks) noexcept;
  bool close_fast(std::uint32_t word, std::uint64_t changed) noexcept;
  bool events_are_seen(std::uint32_t word) const noexcept;
  void queue(std::uint32_t unit) noexcept;
  void touch(std::uint32_t unit) noexcept;

  // the rounds of an instant (engine_advance.cpp)
  void run_rounds() noexcept;
  template <bool kMore>
  void rounds() noexcept;
  void step_all(const std::uint32_t* units, std::uint32_t count, bool counting) noexcept;
  void forget_steps() noexcept;
  bool look_for_loops() noexcept;
  void step_follows(bool counting) noexcept;
  void step(std::uint32_t unit) noexcept;
  void forget_queue() noexcept;
  bool may_leave(const tables::UnitRow& row, const TypeIndex& type, std::uint8_t here) const noexcept;
  void step_settled(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type) noexcept;
  void switch_events_now(const tables::UnitRow& row, const tables::EventMasks& masks) noexcept;
  void leave(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type, std::uint8_t target,
             std::uint16_t transition) noexcept;
  void settle(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type) noexcept;

  // moving units (engine_general.cpp)
  struct Wishes;
  Wishes wishes_of(std::uint32_t unit, const TypeIndex& type, std::uint64_t on) noexcept;
  void step_moving(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type) noexcept;
  bool must_stop(std::uint32_t unit, const TypeIndex& type) const noexcept;
  void turn_round(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                  std::uint16_t transition) noexcept;
  void stop_midway(std::uint32_t unit) noexcept;
  void go_on(std::uint32_t unit) noexcept;
  void stepped(std::uint32_t unit, const tables::UnitRow& row) noexcept;
  void found_conflict(std::uint32_t unit) noexcept;
  void travel(std::uint32_t unit, UnitState& state, tables::Time duration) noexcept;
  void set_wheel(std::uint32_t entry, tables::Time due) noexcept;
  void clear_wheel(std::uint32_t entry) noexcept;

  // causes and times (engine_general.cpp)
  struct Ready;
  Ready ready_transitions(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                          std::uint64_t on) noexcept;
  bool holds_long_enough(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                         std::uint16_t transition, bool held, Record& record) noexcept;
  std::uint16_t drawn_by_weight(std::uint32_t unit, const TypeIndex& type, std::uint16_t first) noexcept;
  std::uint8_t destination(std::uint32_t unit, const TypeIndex& type, std::uint64_t on, const Ready& ready) noexcept;
  tables::Time takes(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type, std::uint8_t target,
                     std::uint16_t transition) noexcept;
  tables::Time after(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                     std::uint16_t transition) noexcept;
  tables::Time takes_otherwise(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                               std::uint8_t target, std::uint16_t transition) noexcept;
  tables::Time takes_by_behaviour(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                  std::uint8_t target, std::uint16_t transition) noexcept;
  tables::Time after_by_behaviour(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                  std::uint16_t transition) noexcept;
  const tables::TransitionTimes& times_of(const tables::UnitRow& row, const TypeIndex& type,
                                          std::uint16_t dt) const noexcept;
  tables::Time drawn(std::uint32_t unit, const TypeIndex& type, std::uint16_t transition, tables::Time time) noexcept;
  tables::Time travel_time(const tables::UnitRow& row, const TypeIndex& type, std::uint8_t from, std::uint8_t to,
                           std::uint16_t& transition) const noexcept;
  std::uint16_t transition_without_command(const TypeIndex& type, std::uint8_t from, std::uint8_t to) const noexcept;
  void halt_times(std::uint32_t unit) noexcept;
  void resume_times(std::uint32_t unit) noexcept;
  const Behaviour* behaviour_of(const GeneralRow& general) const noexcept;
  std::uint32_t wheel_entry_of_requirement(std::uint32_t requirement) const noexcept {
    return static_cast<std::uint32_t>(tables_.units.size()) + requirement;
  }
  std::uint32_t wheel_entry_of_behaviour(std::uint32_t behaviour) const noexcept {
    return wheel_entry_of_requirement(static_cast<std::uint32_t>(tables_.requirements.size())) + behaviour;
  }
  std::uint64_t symbol_value(std::uint32_t symbol) const noexcept {
    const tables::SymbolRow& row = tables_.symbols[symbol];
    return (row.direction() == tables::Direction::operation ? operation_values_ : event_values_).values[row.index];
  }
  std::uint32_t wheel_entry_of_overrun(std::uint32_t position) const noexcept {
    return wheel_entry_of_behaviour(static_cast<std::uint32_t>(tables_.behaviour_units.size())) + position;
  }

  // calls of custom behaviors (behaviour.cpp)
  bool behaves(std::uint32_t unit) const noexcept { return (units_[unit].flags & kBehaves) != 0; }
  void wake_behaviour(std::uint32_t unit, const tables::UnitRow& row) noexcept;
  void report_left(std::uint32_t unit, std::uint8_t state) noexcept;
  void report_entered(std::uint32_t unit, std::uint8_t state) noexcept;
  std::uint8_t wanted_by_behaviour(std::uint32_t unit) noexcept;

  // publishing the changes of one round to the next (engine_publish.cpp)
  void sample_operations(bool fast) noexcept;
  void apply_actions() noexcept;
  template <bool kFast>
  void change_operations(std::uint32_t word, std::uint64_t now) noexcept;
  void change_operation_value(std::uint32_t slot) noexcept;
  void publish() noexcept;
  void publish_event_word(std::uint32_t word) noexcept;
  void publish_values() noexcept;
  void publish_unit(std::uint32_t unit) noexcept;
  void flip_bits(const WatchIndex& watches, std::uint32_t word, std::uint64_t bits) noexcept;
  void compare_value(std::span<const tables::ValueWatch> watches, std::uint32_t slot, std::uint64_t value) noexcept;
  void flip(std::uint32_t condition, std::uint8_t input) noexcept;
  bool looks_at_conditions(std::uint32_t unit) const noexcept;
  void settle_conditions() noexcept;
  void settle_disables() noexcept;
  void disable(std::uint32_t unit) noexcept;
  bool enable(std::uint32_t unit, std::uint16_t flags) noexcept;

  // the end of an instant (engine_close.cpp)
  void close_instant() noexcept;
  std::span<const WordChange> close_events() noexcept;
  void find_start() noexcept;
  std::span<const WordChange> report_start() noexcept;
  std::uint64_t close_cycle(std::uint32_t word, std::uint64_t changed) noexcept;
  void close_event_values() noexcept;
  void close_requirements() noexcept;
  bool close_requirement(std::uint32_t requirement) noexcept;
  bool close_operations() noexcept;
  bool may_be_finding(const WordChange& change) const noexcept;
  void finish_operations(const WordChange& change) noexcept;
  void serve(const UnitState& state, const tables::UnitRow& row) noexcept;
  void finish_units() noexcept;

  // commands against the end of a held unit (engine_close.cpp)
  void close_overruns() noexcept;
  void close_overrun(std::uint32_t unit, std::uint32_t position) noexcept;

  // the findings of an instant (engine_close.cpp)
  void report_findings() noexcept;
  void report(tables::FindingKind kind, std::uint32_t of, bool more) noexcept;
  void report_marked(tables::FindingKind kind) noexcept;
  void report_units(tables::FindingKind kind) noexcept;
  void report_operations(tables::FindingKind kind) noexcept;
  bool is_operation_finding(tables::FindingKind kind, std::uint32_t unit, std::uint32_t bit) const noexcept;
  bool is_frozen_follow(std::uint32_t symbol) const noexcept;
  void report_short_events() noexcept;
  void report_loops() noexcept;
  void report_all(List<std::uint32_t>& collected, tables::FindingKind kind) noexcept;
  template <class Function>
  void for_frozen_now(Function function) noexcept;

  const tables::PlantTables& tables_;
  std::span<const Behaviour> behaviours_;
  EngineIndex index_;
  Flow flow_;
  Malfunctions malfunctions_;
  Values values_;

  // --- in the flat block, from `head` on
  BlockHead* head_;
  UnitState* units_;  ///< followed by wheel entries: requirements, behaviors, overruns, the flow's, the values'
  BitPlane operations_;
  BitPlane events_;
  ValuePlane operation_values_;
  ValuePlane event_values_;
  OperationWord* operation_words_;
  std::uint64_t* written_values_;
  BlockList written_words_;  ///< those that wait to be sampled
  BlockSet written_slots_;
  std::uint64_t* disarmed_;  ///< operations that are disarmed
  GeneralState* general_states_;
  Record* records_;
  std::uint8_t* condition_states_;
  MonitorState* monitors_;
  BehaviourState* behaviour_states_;
  FollowState* follow_states_;
  OverrunState* overrun_states_;
  tables::Time* overrun_begins_;  ///< of each operation of these units: since when it is among OverrunState::commands
  std::byte* behaviour_memory_;
  ShortEvents recent_rises_;  ///< of events, in real time
  std::size_t block_size_;

  // --- outside the flat block: not part of the saved state
  PlaneWords operation_plane_;
  PlaneWords event_plane_;
  EventChanges event_changes_;
  DirtySet changed_event_slots_;
  Pulses pulses_;              ///< of events, in real time
  std::uint64_t* on_request_;  ///< events that a link shows on request
  tables::Time cycle_end_;     ///< the time of the last forget_changed_events(); -1: none since a reset or restore
  FindingRing findings_;
  const std::uint64_t* name_hashes_;    ///< of each general unit: fnv1a64 of its name in upper case
  const std::uint64_t* memory_begins_;  ///< of each behavior's unit: offset in behaviour_memory; one more at the end
  std::uint32_t* queue_;                ///< capacity for every unit once
  std::uint32_t queued_;                ///< number of units in queue_ for the next round (from the second round on)
  std::uint32_t round_;                 ///< of this instant, from 1; 0 before its first round and between instants
  List<std::uint32_t> touched_;         ///< touched in this instant; those touched before its first round step in it
  List<std::uint32_t> moved_;           ///< general units that stepped in this round
  List<std::uint32_t> counted_;         ///< general units whose disabled_by changed in this round
  List<std::uint32_t> waiting_;         ///< conditions to evaluate
  DirtySet touched_requirements_;
  DirtySet due_follows_;          ///< those whose condition changed since their last step
  DirtySet touched_slots_;        ///< event slots that changed in this instant
  std::uint64_t* values_before_;  ///< those slots as they were when the instant began
  List<WordChange> operation_changes_;
  List<std::uint32_t> operation_slot_changes_;
  List<std::uint32_t> event_slot_changes_;
  MarkRange marks_;                ///< units, symbols or requirements to report, in ascending order
  std::uint32_t suspects_;         ///< one bit per kind of finding: this instant may have one
  std::uint8_t loops_;             ///< number of loops frozen in this instant
  List<std::uint32_t> violated_;   ///< requirements violated in this instant
  List<std::uint32_t> blocked_;    ///< transfers that began to be blocked in this instant
  List<std::uint32_t> overrun_;    ///< units that began to overrun in this instant
  List<WordChange> short_events_;  ///< events found too short in this instant
  bool unseen_events_;             ///< no event is forced, watched by a condition, or on a shared address
  bool reported_any_;              ///< this instant has a finding
  bool first_;                     ///< this is the first instant, and some symbols are inverted
  bool closes_more_;  ///< the plant has inverted symbols, units that can overrun, material, values, or written
                      ///< malfunctions
  bool unpublished_;  ///< publish() has work to do
  bool active_;       ///< a unit stepped, or was disabled or enabled, in this round
  tables::Time now_;  ///< the time of this instant
  Observer* observer_;
};

}  // namespace symplant::engine
