// Look-ups for the running engine, built once from the tables.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/shared_positions.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

inline constexpr std::uint16_t kNoRecord = 0xFFFF;
inline constexpr std::uint16_t kNoTransition = 0xFFFF;

/// What a settled unit of a plain type does if at most one of its operations is on.
struct Departure {
  std::uint16_t transition;  ///< kNoTransition for a spring return
  std::uint16_t dt;          ///< its times, as Transition::dt
  std::uint32_t to;  ///< the same state: the operation leads there, so the unit stays; kNoState: see the general path
};

/// What a unit reads in one state of its type.
struct StateIndex {
  tables::EventMasks enter;
  tables::EventMasks leave;
  std::uint64_t starts;         ///< the operations that are the `on` of a transition from it
  std::uint64_t leads;          ///< the operations that lead to it
  const Departure* departures;  ///< of a plain type: without an operation, then by operation
  std::uint32_t from_begin;     ///< its first index in from_order; those of the next state follow
  bool automatic;               ///< an automatic transition starts from it

  /// Only of a plain type. `on`: the operations that are on, at most one.
  const Departure& departure(std::uint64_t on) const noexcept { return departures[std::bit_width(2 * on + 1) - 1]; }
};

/// A type's transitions by the state from which they start, and its operations as masks (bit o: operation o).
struct TypeIndex {
  const StateIndex* at;  ///< by state; one more at the end
  const tables::Transition* transitions;
  const std::uint16_t* from_order;       ///< transition numbers by the state from which they start, in table order
  const std::uint16_t* record_of;        ///< a transition -> its index among its unit's records, or kNoRecord
  const tables::TransitionTimes* times;  ///< those that all devices share
  std::uint64_t operations;              ///< all of them
  std::uint32_t records;                 ///< transitions with a record
  std::uint8_t states;
  std::uint8_t events;
  std::uint8_t rest;
  tables::Actuation actuation;
  std::uint16_t travel;  ///< TypeRow::travel
  /// No transition is automatic or has a `when`, a `during`, a record or a `once`, and no unit can overrun: a unit's
  /// step reads only its operations. It has less than 64 of them, so that StateIndex::departure() is cheap.
  bool plain;
  bool stoppable;  ///< a transition has a `during`

  std::span<const std::uint16_t> from(std::uint8_t state) const noexcept {
    return {from_order + at[state].from_begin, from_order + at[state + 1].from_begin};
  }
};

/// Maps an operation's bit to its unit, with one byte per bit (see kMaxUnitsInWord).
class UnitOfOperation {
 public:
  void build(const tables::PlantTables& tables, Arena& arena) noexcept;
  /// kNone if the operation belongs to no unit. O(1).
  std::uint32_t operator[](std::uint32_t bit) const noexcept {
    const std::uint8_t step = steps_[bit];
    return step == kNoStep ? tables::kNone : first_[bit / 64] + step;
  }
  /// The bits of one word.
  class Word {
   public:
    std::uint32_t operator[](std::uint32_t bit) const noexcept {
      return steps_[bit] == kNoStep ? tables::kNone : first_ + steps_[bit];
    }

   private:
    friend class UnitOfOperation;
    Word(std::uint32_t first, const std::uint8_t* steps) noexcept : first_(first), steps_(steps) {}
    std::uint32_t first_;
    const std::uint8_t* steps_;
  };
  Word of_word(std::uint32_t word) const noexcept { return {first_[word], steps_ + std::size_t{word} * 64}; }

 private:
  static constexpr std::uint8_t kNoStep = 0xFF;
  const std::uint32_t* first_ = nullptr;  ///< a word -> the first unit that has a bit in it
  const std::uint8_t* steps_ = nullptr;   ///< a bit -> the index of its unit minus that first unit, or kNoStep
};

/// Indexes of a general unit's rows in other tables.
struct GeneralRow {
  std::uint32_t unit;
  std::uint32_t first_condition;  ///< of its conditions (ConditionedUnit)
  std::uint32_t first_record;     ///< of its transitions' records
  std::uint32_t watch_begin;      ///< in PlantTables::unit_watches
  std::uint32_t watch_end;
  std::uint32_t disable_begin;  ///< in PlantTables::disables
  std::uint32_t disable_end;
  std::uint32_t behaviour;  ///< in PlantTables::behaviour_units, or tables::kNone
};

/// The general units (UnitRow::general). Needs no memory if a plant has none, else four bytes for every unit.
class GeneralUnits {
 public:
  void build(const tables::PlantTables& tables, const TypeIndex* types, Arena& arena) noexcept;

  std::span<const GeneralRow> rows() const noexcept { return {rows_, size_}; }
  std::uint32_t size() const noexcept { return size_; }
  std::uint32_t records() const noexcept { return records_; }
  /// The index of a unit among the general units. Only for a unit with UnitRow::general. O(1).
  std::uint32_t position_of(std::uint32_t unit) const noexcept { return positions_[unit]; }
  const GeneralRow& row_of(std::uint32_t unit) const noexcept { return rows_[positions_[unit]]; }

 private:
  void fill(const tables::PlantTables& tables, const TypeIndex* types, GeneralRow* rows) noexcept;

  const GeneralRow* rows_ = nullptr;
  const std::uint32_t* positions_ = nullptr;
  std::uint32_t size_ = 0;
  std::uint32_t records_ = 0;
};

/// Maps a bit to the watches on it.
class WatchIndex {
 public:
  void build(std::span<const tables::BitWatch> watches, std::uint32_t bits, Arena& arena) noexcept;
  bool empty() const noexcept { return watches_.empty(); }
  /// The bits of a word that are watched.
  std::uint64_t watched(std::uint32_t word) const noexcept { return marks_ == nullptr ? 0 : marks_[word]; }
  /// O(log watches of the word).
  std::span<const tables::BitWatch> on(std::uint32_t bit) const noexcept;

 private:
  std::span<const tables::BitWatch> watches_;
  const std::uint64_t* marks_ = nullptr;   ///< null: nothing is watched
  const std::uint32_t* begins_ = nullptr;  ///< a word -> its first watch; one more at the end
};

/// The units with an OverrunRow. Needs no memory if there is none, else four bytes for every unit.
class OverrunIndex {
 public:
  void build(const tables::PlantTables& tables, Arena& arena) noexcept;
  bool empty() const noexcept { return positions_ == nullptr; }
  std::uint32_t operations() const noexcept { return operations_; }  ///< of all these units
  /// The index of a unit's row, or kNone. Not to be called if empty(). O(1).
  std::uint32_t position_of(std::uint32_t unit) const noexcept { return positions_[unit]; }
  /// The first of the unit's operations among those of all these units.
  std::uint32_t first_operation(std::uint32_t position) const noexcept { return first_operations_[position]; }

 private:
  const std::uint32_t* positions_ = nullptr;
  const std::uint32_t* first_operations_ = nullptr;
  std::uint32_t operations_ = 0;
};

/// A unit whose custom behavior reads a numeric symbol.
struct ValueReader {
  std::uint32_t position;  ///< an operation's slot, or kSharedSlot + an event's
  std::uint32_t unit;
};

class ValueReaders {
 public:
  void build(const tables::PlantTables& tables, Arena& arena) noexcept;
  /// The readers of a slot. O(log readers).
  std::span<const ValueReader> of(tables::Direction direction, std::uint32_t slot) const noexcept;

 private:
  std::span<const ValueReader> readers_;
};

struct EngineIndex {
  void build(const tables::PlantTables& tables, Arena& arena) noexcept;

  const TypeIndex* types = nullptr;
  UnitOfOperation unit_of_operation;
  GeneralUnits general;
  WatchIndex operation_watches;
  WatchIndex event_watches;
  ValueReaders value_readers;
  OverrunIndex overruns;
  SharedPositions shared_operations;
  SharedPositions shared_events;
  const std::uint32_t* symbol_of_operation = nullptr;  ///< a bit -> the symbol
  const std::uint32_t* symbol_of_event = nullptr;
  const std::uint64_t* inverted_operations = nullptr;  ///< masks over the planes
  const std::uint64_t* inverted_events = nullptr;
  bool some_inverted = false;
};

}  // namespace symplant::engine
