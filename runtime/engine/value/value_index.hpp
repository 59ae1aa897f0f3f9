// Look-ups of values: the readers of an output, a symbol, a number of parts; groups of equal steps.
#pragma once

#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/dirty_set.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

/// For each of some sources, the numbers of its readers.
struct Readers {
  std::uint32_t* begins = nullptr;
  std::uint32_t* readers = nullptr;

  std::span<const std::uint32_t> of(std::uint32_t source) const noexcept {
    return {readers + begins[source], readers + begins[source + 1]};
  }
};

/// What each computation of a value needs.
struct ValueStep {
  double h;  ///< the step in seconds
  double min;
  double max;
  double factor;
  std::uint32_t value;
  std::uint32_t output;
  std::uint32_t formula;
  std::uint16_t formulas;
  tables::ValueKind kind;
  bool timed;  ///< a formula of it reads the time
};

/// A set of ranks, one bit each.
struct RankSet {
  std::uint64_t* words = nullptr;
  std::uint32_t begin = 0;  ///< the first word with a rank
  std::uint32_t end = 0;    ///< after the last one

  void add(std::uint32_t rank) noexcept {
    const std::uint32_t word = rank / 64;
    begin = end == 0 || word < begin ? word : begin;
    end = word < end ? end : word + 1;
    words[word] |= bit_in_word(rank);
  }
};

/// What sees that an output changes.
struct OutputUse {
  std::uint32_t readers;      ///< the first one in ValueIndex::output_readers
  std::uint32_t readers_end;  ///< ranks of the owners that read it, maybe several times
  std::uint32_t trace;        ///< ValueIndex::trace_count: it is in no trace
  bool others;                ///< comparisons read it, or drives may
};

/// A value or signal as the owner of a formula: values first, then signals; kNone: a jump. A rank is its place in the
/// order of computation: values that step by kind, then the others in their order, then signals.
struct ValueIndex {
  /// O(formulas + symbols).
  void build(const tables::PlantTables& tables, Arena& arena) noexcept;

  std::uint32_t value_count = 0;
  std::uint32_t signal_count = 0;
  std::uint32_t group_count = 0;
  std::uint32_t memory_size = 0;
  tables::Time* steps = nullptr;   ///< by group
  tables::Time* traces = nullptr;  ///< different intervals of traces
  std::uint32_t trace_count = 0;
  std::uint32_t* group_at = nullptr;       ///< by rank; kNone: a parameter
  std::uint32_t* rank_of = nullptr;        ///< by owner
  ValueStep* step_at = nullptr;            ///< by rank, of values
  std::uint32_t* rank_of_input = nullptr;  ///< of the owner of its formula; kNone: a jump
  std::uint32_t* value_of_change = nullptr;
  std::uint32_t* memory = nullptr;        ///< by value: its first number in the memory
  std::uint8_t* timed_signals = nullptr;  ///< by signal: its formula reads the time
  // What a formula sees is in one array: the outputs, then what else each input reads, then the time.
  std::uint32_t* slots = nullptr;  ///< by input: where it is there
  std::uint32_t time_slot = 0;
  bool reads_time = false;
  tables::FormulaStep* formula_steps = nullptr;  ///< with slots for inputs; null if the formulas are compiled
  RankSet stepping;                              ///< values that make steps from stored inputs
  RankSet computed;                              ///< values that are computed from others
  RankSet signals;
  OutputUse* uses = nullptr;  ///< by output
  std::uint32_t* output_readers = nullptr;
  Readers of_operation_value;
  Readers of_event_value;
  Readers of_counter;
  Readers of_weight;
  Readers comparisons_of_output;
  std::uint32_t* others = nullptr;  ///< comparisons that read something else than outputs, too
  std::uint32_t other_count = 0;

  std::span<const std::uint32_t> other_comparisons() const noexcept { return {others, other_count}; }

 private:
  void rank_all(const tables::ValueTables& values) noexcept;
  void find_inputs(const tables::ValueTables& values) noexcept;
};

}  // namespace symplant::engine
