// The malfunctions of a plant: which are active, what starts and ends them, and what they do (docs/malfunctions.md).
//
// They change a plant as actions from outside do, before the first round of an instant. Without active malfunctions
// they do not affect the plant.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/block.hpp"
#include "symplant/engine/dirty_set.hpp"
#include "symplant/engine/instant.hpp"
#include "symplant/engine/malfunction/active_malfunction.hpp"
#include "symplant/engine/planes.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

class Engine;

/// The numbers of a malfunction's streams of random times; the flicker that is effect n has kEveryStream + n.
inline constexpr std::uint16_t kChanceStream = 0;
inline constexpr std::uint16_t kLastsStream = 1;
inline constexpr std::uint16_t kEveryStream = 2;

/// The changing state of a written malfunction. Times that are not given or not running are kNever.
struct MalfunctionState {
  tables::Time since;      ///< when it started; 0 if it is not active
  tables::Time due;        ///< active: when it ends by itself; else: when it starts by chance
  tables::Time becomes;    ///< when it becomes another one
  tables::Time by_itself;  ///< when it last started by its condition
  std::array<std::uint32_t, 2> draws;
  std::uint32_t counted;  ///< its starts and ends, as Malfunctions::Head::counted
  std::uint32_t begun;    ///< active: how many of its effects have begun
  std::uint8_t active;
  std::uint8_t held;    ///< its condition held at the end of the last instant
  std::uint8_t wishes;  ///< of the next instant: kStarts, kEnds
  std::uint8_t frozen;  ///< 0: it is not; kFrozenBefore, kFrozenInThisInstant: it was in an instantaneous loop
  std::uint8_t waits;   ///< `while`: it was stopped from outside, and its condition has held since
  std::uint8_t unused[3];
};

/// The changing state of an effect of kind `flicker`.
struct EffectState {
  tables::Time due;     ///< when its symbol changes next
  std::uint32_t draws;  ///< of `every`
  std::uint8_t shows;   ///< its symbol shows the opposite
  std::uint8_t unused[3];
};

class Malfunctions {
 public:
  using By = MalfunctionChange::By;

  explicit Malfunctions(Engine& engine) noexcept;

  // Memory (malfunction_memory.cpp).
  void place(Arena& arena) noexcept;  ///< what is outside the flat block
  void place_block(Arena& arena) noexcept;
  void reset() noexcept;
  /// Looks at all conditions at the end of the next instant, as in the first one.
  void mark_all() noexcept;
  void hash(tables::Fnv1a64& hash) const noexcept;

  /// Whether the plant has written ones.
  bool written() const noexcept { return written_ != 0; }
  std::span<const ActiveMalfunction> active() const noexcept { return {active_, head_->active}; }
  /// An active malfunction; null if it is not active. O(active ones).
  const ActiveMalfunction* find(std::uint32_t number) const noexcept;
  /// The next time at which one changes by itself. O(1) for all together.
  tables::Time next_due() const noexcept { return head_->next; }
  tables::Time next_due(std::uint32_t number) const noexcept;
  bool is_stuck(std::uint32_t unit) const noexcept;
  bool is_cut(std::uint32_t controller) const noexcept;
  /// The one that overrides a symbol, forced by the user or not; kNone: none.
  std::uint32_t of_symbol(std::uint32_t symbol) const noexcept;
  /// The speed of a drive of a track that would be `speed` without malfunctions, in um/s.
  std::int64_t slowed_drive(std::uint32_t track, std::int64_t speed) const noexcept;
  /// Calls `function(effect, since)` for the active effects that distort a signal, in the order of the description.
  template <class Function>
  void for_distortions(std::uint32_t signal, Function function) const noexcept {
    if (head_->distorting == 0) return;
    for (std::uint32_t m = 0; m < written_; ++m) {
      for (const tables::EffectRow& effect : active_effects(m)) {
        if (effect.kind == tables::MalfunctionKind::distort && effect.subject == signal)
          function(effect, states_[m].since);
      }
    }
  }

  // Changes (malfunction_changes.cpp). Between instants.
  bool start(std::uint32_t number, By by) noexcept;
  bool stop(std::uint32_t number, By by) noexcept;
  /// Makes the changes that are due at now(). Before the instant there.
  void begin() noexcept;
  void condition_changed(std::uint32_t number) noexcept { seen_.mark(number); }
  /// Looks at the conditions at the end of an instant.
  void close() noexcept;
  /// Whether a further instant at the same time must make changes.
  bool pending() const noexcept { return head_->pending != 0; }
  std::span<const MalfunctionChange> changes() const noexcept { return changes_.view(); }
  void forget_changes() noexcept { changes_.size = 0; }
  /// Calls `function(member, loop)` for each that was frozen in this instant; the members are numbered from `first`.
  template <class Function>
  void for_frozen_now(std::uint32_t first, Function function) const noexcept {
    for (std::uint32_t m = 0; m < written_; ++m) {
      if (states_[m].frozen == kFrozenInThisInstant) function(first + m, head_->loop);
    }
  }
  void close_loops() noexcept;

  // What they do (malfunction_effects.cpp).
  /// The travel time of a unit's move that begins now and would take `time`.
  tables::Time slowed(std::uint32_t unit, const tables::UnitRow& row, tables::Time time) noexcept;
  /// The total time of the current move of a unit without a GeneralState; `time` is that of the tables.
  tables::Time whole(std::uint32_t unit, tables::Time time) const noexcept;
  /// Overrides a symbol as the active ones do together, if the user does not force it.
  void override_again(std::uint32_t symbol) noexcept;

 private:
  struct Head {
    tables::Time next;          ///< the earliest time of the written ones
    tables::Time window_begin;  ///< of the millisecond in which starts and ends are counted
    std::uint32_t active;       ///< the number of active ones
    std::uint32_t ordinary;     ///< the number of ordinary ones among them
    std::uint32_t counted;      ///< starts and ends of written ones in that millisecond
    std::uint32_t distorting;   ///< active effects of kind `distort`
    std::uint32_t on_tracks;    ///< active effects that name tracks
    std::uint8_t pending;       ///< 1: the `wishes` of some are not empty, or is_loop() after a change from outside
    std::uint8_t loop;          ///< the number in its instant of the loop that was frozen last
    std::uint16_t unused;
  };

  const tables::MalfunctionRow& row(std::uint32_t number) const noexcept { return tables_.malfunctions.rows[number]; }
  tables::Time now() const noexcept;
  tables::Time drawn(std::uint32_t number, tables::Time time, std::uint16_t stream, std::uint32_t& draws) noexcept;
  tables::Time after(std::uint32_t number, tables::Time time, std::uint16_t stream) noexcept;
  tables::Time next_flicker(std::uint32_t number, std::uint32_t effect) noexcept;
  void begin_one(std::uint32_t number) noexcept;
  void become(std::uint32_t number) noexcept;
  void flicker(std::uint32_t number) noexcept;
  void close(std::uint32_t number) noexcept;
  void end(std::uint32_t number, By by) noexcept;
  void set_next() noexcept;
  void note(std::uint32_t number, bool active, By by) noexcept;
  void count(std::uint32_t number) noexcept;
  /// Whether those that started or ended again and again in this millisecond are a loop.
  bool is_loop() const noexcept { return head_->counted > kMostInLoopWindow; }
  void freeze_loop() noexcept;

  EffectState& effect_state(std::uint32_t number, std::uint32_t effect) const noexcept {
    return effects_[row(number).effects.first + effect];
  }
  /// The effects of a written one that have begun; none if it is not active.
  std::span<const tables::EffectRow> active_effects(std::uint32_t number) const noexcept {
    return tables_.malfunctions.effects.subspan(row(number).effects.first, states_[number].begun);
  }
  void hash_effects(std::uint32_t number, tables::Fnv1a64& hash) const noexcept;
  bool is_active(std::uint32_t number) const noexcept;
  void affect(std::uint32_t number) noexcept;
  void affect(const tables::EffectRow& effect) noexcept;
  void release(std::uint32_t number) noexcept;
  void release(const tables::EffectRow& effect) noexcept;
  void hold(const tables::EffectRow& effect) noexcept;
  void set_again(const tables::EffectRow& effect) noexcept;
  void count_effect(const tables::EffectRow& effect, std::uint32_t change) noexcept;
  void stick(std::uint32_t unit, std::uint8_t state) noexcept;
  void unstick(std::uint32_t unit) noexcept;
  void slow(std::uint32_t unit) noexcept;
  void set_whole(std::uint32_t unit, tables::Time time, bool slower) noexcept;
  tables::Time* place_of_whole(std::uint32_t unit) const noexcept;
  std::uint64_t address_of(std::uint32_t symbol) const noexcept;
  std::uint64_t value_of(const tables::MalfunctionForce& force) const noexcept;
  std::uint64_t shown(std::uint32_t symbol) const noexcept;
  Override override_of(std::uint32_t symbol) const noexcept;

  Engine& engine_;
  const tables::PlantTables& tables_;
  tables::MalfunctionNumbers numbers_;
  std::uint32_t written_;

  // --- in the flat block
  Head* head_;
  MalfunctionState* states_;   ///< of the written ones
  EffectState* effects_;       ///< of their effects
  std::uint64_t* holds_;       ///< by force: what it holds
  ActiveMalfunction* active_;  ///< in the order in which they started
  std::uint64_t* slowed_;      ///< one bit per unit: `whole` is not the time of the tables
  tables::Time* wholes_;       ///< of those of slow_units_

  // --- outside of it
  const std::uint64_t* name_hashes_;  ///< fnv1a64 of each written one's name in upper case
  List<std::uint32_t> slow_units_;    ///< units of written `slower`, ascending
  DirtySet seen_;                     ///< written ones to look at when this instant ends
  List<MalfunctionChange> changes_;
  std::uint32_t most_changes_;
};

}  // namespace symplant::engine
