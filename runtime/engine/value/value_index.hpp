// Look-ups of values: the readers of an output, a symbol, a number of parts; groups of equal steps.
#pragma once

#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
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

/// A value or signal as the owner of a formula: values first, then signals; kNone: a jump.
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
  std::uint32_t* trace_of = nullptr;  ///< by value; kNone: it is in no trace
  std::uint32_t* group_of = nullptr;  ///< by owner; kNone: a parameter
  std::uint32_t* rank_of = nullptr;   ///< by owner: those that step first, then the others in their order, signals
  std::uint32_t* owner_at = nullptr;  ///< by rank
  std::uint32_t* owner_of_input = nullptr;
  std::uint32_t* value_of_output = nullptr;
  std::uint32_t* value_of_change = nullptr;
  std::uint32_t* memory = nullptr;  ///< by value: its first number in the memory
  std::uint8_t* timed = nullptr;    ///< by owner: a formula of it reads the time
  Readers of_output;                ///< inputs
  Readers of_operation_value;
  Readers of_event_value;
  Readers of_counter;
  Readers of_weight;
  Readers comparisons_of_output;
};

}  // namespace symplant::engine
