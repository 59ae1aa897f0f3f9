// The values and signals of a plant: numbers that change with time by formulas (docs/values.md).
//
// A value is computed at whole multiples of its step, in the first instant of that time and before its rounds. It costs
// nothing while its inputs do not change and its step changes nothing.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/block.hpp"
#include "symplant/engine/dirty_set.hpp"
#include "symplant/engine/round_marks.hpp"
#include "symplant/engine/value/output_range.hpp"
#include "symplant/engine/value/value_index.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/formula.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

class Engine;

/// The changing state of a value in addition to its outputs, stored inputs and memory.
struct ValueState {
  tables::Time set_at;      ///< when it was last set by hand; -1: never
  std::uint32_t draws;      ///< of `noise`
  std::uint32_t oldest;     ///< `delay`: where the oldest stored input is
  std::uint32_t equal;      ///< `delay`: how many of the last stored inputs are equal
  std::uint8_t stored;      ///< 1: its inputs were stored at its last computation
  std::uint8_t remembers;   ///< `derivative`, `pid`: 1: there is a last u or `of`
  std::uint8_t not_finite;  ///< the finding holds
  std::uint8_t frozen;      ///< as FollowState::frozen
  std::uint8_t steps;       ///< as FollowState::steps
  std::uint8_t found;       ///< `not_finite` at the end of the last instant
  std::uint8_t held;        ///< a malfunction holds the parameter; its memory is the number without it
  std::uint8_t unused[1];
};

class Values {
 public:
  // build() and place() set all other members.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  explicit Values(Engine& engine) noexcept : engine_(engine) {}

  // Memory (values_memory.cpp). The calls are in this order.
  void build(Arena& arena) noexcept;  ///< the look-ups
  void place(Arena& arena) noexcept;  ///< what is outside the flat block
  void place_block(Arena& arena, std::uint32_t entry) noexcept;
  void reset() noexcept;
  std::uint32_t wheel_entries() const noexcept { return active_ ? 1 : 0; }
  /// Everything is due in the next instant. O(values).
  void mark_all() noexcept;
  void hash(tables::Fnv1a64& hash) const noexcept;
  void hash_not_finite(tables::Fnv1a64& hash) const noexcept;

  bool active() const noexcept { return active_; }
  /// Before an instant at a time, after now() is set.
  void begin_instant() noexcept;
  /// After the instant at now(), also if there was none since nothing would have changed.
  void end_time() noexcept { head_->instant = now(); }
  /// The wheel's entry is due; after begin_instant().
  void entry_due() noexcept {
    if (!due_) set_wheel();  // else compute() does
  }
  /// Whether this instant must compute something.
  bool due() const noexcept { return due_; }
  /// Computes what is due, before the rounds (values_compute.cpp).
  void compute() noexcept;
  void condition_changed(tables::ReaderKind kind, std::uint32_t reader, bool truth) noexcept;
  void value_changed(tables::Direction direction, std::uint32_t slot, std::uint64_t value) noexcept;
  void counter_changed(std::uint32_t counter, std::uint64_t count) noexcept;
  void weight_changed(std::uint32_t location) noexcept;

  // Jumps (values_round.cpp).
  bool jumps_due() const noexcept { return active_ && !due_changes_.empty(); }
  void round(bool counting) noexcept;
  /// After a restore: conditions and comparisons are looked at again.
  void requeue() noexcept;
  /// Passes on the outputs that changed since the last call, and compares them.
  void publish() noexcept;
  void forget_steps() noexcept;
  bool has_loop() const noexcept;
  void freeze_loop(std::uint8_t loop) noexcept;
  template <class Function>
  void for_frozen_now(std::uint32_t first, Function function) const noexcept {
    for (std::uint32_t v = 0; v < tables_->rows.size(); ++v) {
      if (states_[v].frozen == kFrozenInThisInstant) function(first + v, states_[v].steps);
    }
  }
  void close_loops() noexcept;
  /// Calls `function(value)` for values whose finding began in this instant, in no order.
  template <class Function>
  void for_not_finite(Function function) const noexcept {
    for (const std::uint32_t v : finite_changes_.list.view()) {
      if (states_[v].not_finite != 0 && states_[v].found == 0) function(v);
    }
  }

  double output(std::uint32_t output) const noexcept { return outputs_[output]; }
  /// The time that a formula gives in seconds, from 0 to 1e9 s; 0 if it is not a number.
  tables::Time time_of(std::uint32_t formula) noexcept;
  bool reads_weight(std::uint32_t location) const noexcept {
    return !index_.of_weight.of(location).empty() || !tables_->comparisons.empty();
  }
  /// Sets the output of a parameter, integral, lag or ramp, limited. False if the value is of another kind.
  bool set(std::uint32_t value, double number) noexcept;
  /// A malfunction holds a parameter at a number, limited; null: none does any more. What scenario, panel and jumps set
  /// meanwhile is seen at the end.
  void hold(std::uint32_t value, const double* number) noexcept;
  /// A malfunction begins or ends to distort a signal.
  void wake_signal(std::uint32_t signal) noexcept { activate(index_.value_count + signal); }
  /// At the end of an instant, for an observer: the outputs that changed since a trace last showed them, and that it
  /// shows at this time, in their order. Valid until forget_changes().
  std::span<const std::uint32_t> take_shown() noexcept;
  /// Whether an output changed in this instant, or a trace may show one that changed before.
  bool has_changes() const noexcept { return active_ && (changed_ || shows_); }
  void forget_changes() noexcept {
    changed_ = false;
    finite_changes_.take_all([this](std::uint32_t v) { states_[v].found = states_[v].not_finite; });
  }
  /// After a restore: every output may differ from what an observer knows.
  void show_all() noexcept;
  /// A trace that begins now shows every output at its next multiple, also those that do not change.
  void show_from_here() noexcept;
  /// From now on the ranges of all outputs are noted. O(outputs).
  void watch() noexcept;
  /// Since watch().
  OutputRange range(std::uint32_t output) const noexcept { return ranges_[output]; }

 private:
  /// Bit by bit.
  static bool same(double a, double b) noexcept {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  }
  static double limited(double number, double min, double max) noexcept;

  tables::Time now() const noexcept;
  double evaluate(std::uint32_t formula) noexcept {
    const tables::FormulaRow& row = tables_->formulas[formula];
    if (!tables_->compiled.empty()) return tables_->compiled[formula].call(seen_, index_.slots + row.inputs.first);
    return tables::evaluate({index_.formula_steps + row.steps.first, row.steps.count}, tables_->numbers, seen_);
  }
  void give_later(std::uint32_t output, double number) noexcept;
  void give_by_hand(std::uint32_t value, double number) noexcept;
  void jump(std::uint32_t value, double number) noexcept;
  void note_change(std::uint32_t output) noexcept;
  void widen(std::uint32_t output) noexcept;
  void pass_on(std::uint32_t output) noexcept;
  void pass_on_further(std::uint32_t output) noexcept;
  void pass_on_later() noexcept;
  void set_input(std::uint32_t input, double number) noexcept;
  bool is_awake(std::uint32_t rank) const noexcept { return (awake_[rank / 64] & bit_in_word(rank)) != 0; }
  void wake(std::uint32_t rank) noexcept;
  void sleep(std::uint32_t rank) noexcept;
  void activate(std::uint32_t owner) noexcept {
    if (!is_awake(index_.rank_of[owner])) wake(index_.rank_of[owner]);
  }
  void set_wheel() noexcept;

  // Steps of a computation (values_compute.cpp). They return what happened, as Pass.
  using Pass = std::uint8_t;
  static constexpr Pass kMoved = 1;   ///< something changed
  static constexpr Pass kFailed = 2;  ///< a result is not finite
  /// Calls `function(rank)` for each rank of a set that is awake and due, in their order; also for those that a call
  /// wakes.
  template <class Function>
  void for_due(const RankSet& ranks, Function function) noexcept {
    for (std::uint32_t word = ranks.begin; word < ranks.end; ++word) {
      std::uint64_t left = ranks.words[word];
      while ((left & awake_[word]) != 0) {
        const auto bit = static_cast<std::uint32_t>(std::countr_zero(left & awake_[word]));
        left &= ~std::uint64_t{1} << bit;
        const std::uint32_t rank = word * 64 + bit;
        if (all_due_ || due_groups_[index_.group_at[rank]] != 0) function(rank);
      }
    }
  }
  Pass give(const ValueStep& step, double result) noexcept;
  Pass step(const ValueStep& step) noexcept;
  Pass step_linear(const ValueStep& step) noexcept;
  void compute(std::uint32_t rank) noexcept;
  Pass compute_derivative(const ValueStep& step) noexcept;
  Pass compute_pid(const ValueStep& step) noexcept;
  Pass compute_linear(const ValueStep& step) noexcept;
  double position(const tables::ValueRow& row) const noexcept;
  Pass store(const ValueStep& step) noexcept;
  Pass store_all(const ValueStep& step) noexcept;
  Pass store_delayed(const ValueStep& step, double u) noexcept;
  void compute_signals() noexcept;
  bool distort(std::uint32_t signal, double& number) const noexcept;
  void close(std::uint32_t rank, Pass pass) noexcept;
  void set_finite(std::uint32_t value, bool finite) noexcept;
  double normal(std::uint64_t name, std::uint32_t& draws) const noexcept;
  std::uint64_t shown(const tables::SignalRow& row, double number) const noexcept;
  double* memory(std::uint32_t value) const noexcept { return memory_ + index_.memory[value]; }

  void compare(std::uint32_t comparison) noexcept;
  double operand(const tables::Operand& operand) const noexcept;
  void act(std::uint32_t change) noexcept;

  Engine& engine_;
  const tables::ValueTables* tables_ = nullptr;
  ValueIndex index_;
  bool active_ = false;

  /// In the flat block.
  struct Head {
    tables::Time instant;    ///< the last time whose first instant is over; -1: none
    std::uint64_t computed;  ///< 1: values have been computed: comparisons are valid
  };
  Head* head_ = nullptr;
  double* outputs_ = nullptr;
  double* seen_ = nullptr;    ///< what formulas see: outputs as last passed on, then ValueIndex::slots
  double* stored_ = nullptr;  ///< by formula: the stored input of a value
  double* memory_ = nullptr;
  ValueState* states_ = nullptr;
  std::uint8_t* held_ = nullptr;    ///< by change: its condition held in the last round
  std::uint8_t* truths_ = nullptr;  ///< by comparison
  std::uint32_t* signal_draws_ = nullptr;
  std::uint64_t* awake_ = nullptr;        ///< by rank: values, then signals, that may change at their next computation
  std::uint32_t* awake_count_ = nullptr;  ///< by group
  std::uint8_t* traces_ = nullptr;        ///< by trace: an output changed that a trace shows at its next multiple
  std::uint32_t entry_ = 0;               ///< in the wheel

  // Outside of it.
  DirtySet changed_outputs_;           ///< not passed on yet
  std::uint64_t* unshown_ = nullptr;   ///< one bit per output that changed since a trace last showed it
  List<std::uint32_t> shown_{};        ///< of take_shown()
  std::uint8_t* off_trace_ = nullptr;  ///< by trace: it shows nothing at this time
  RoundMarks due_changes_;
  DirtySet finite_changes_;               ///< values whose finding began or ended in this instant
  double* results_ = nullptr;             ///< of one linear value
  std::uint64_t* numbers_ = nullptr;      ///< of the signals, before they are written
  std::uint8_t* drifts_ = nullptr;        ///< by signal: a malfunction makes it drift
  std::uint8_t* due_groups_ = nullptr;    ///< by group: it is due in the first instant of this time
  Pass* passes_ = nullptr;                ///< by rank: what happened in this computation so far
  const std::uint64_t* names_ = nullptr;  ///< fnv1a64 of the names of values, then of signals, in upper case
  bool due_ = false;
  bool all_due_ = false;           ///< everything is due in the first instant of this time
  OutputRange* ranges_ = nullptr;  ///< by output, if they are watched
  bool watched_ = false;
  bool shows_ = false;    ///< this is an instant at which a trace shows outputs that changed before
  bool changed_ = false;  ///< an output changed in this instant
  bool computing_ = false;
  bool compares_others_ = false;  ///< a symbol or a number of parts changed that comparisons may read
};

}  // namespace symplant::engine
