// The tables of a plant: plain rows, the same for generated code and for tables made at run time.
//
// The tables do not change while a plant runs. Rows refer to each other by index. The owner of the tables keeps them
// alive while a plant uses them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/malfunction.hpp"
#include "symplant/tables/material.hpp"
#include "symplant/tables/number.hpp"
#include "symplant/tables/time.hpp"
#include "symplant/tables/value.hpp"

namespace symplant::tables {

inline constexpr std::uint8_t kNoState = 0xFF;
inline constexpr std::uint8_t kNoOperation = 0xFF;   ///< Transition::on of an automatic transition
inline constexpr std::uint8_t kSpringReturn = 0xFE;  ///< Transition::on of a spring return: its cause never holds
inline constexpr std::uint16_t kNoCondition = 0xFFFF;
inline constexpr std::uint32_t kNone = 0xFFFF'FFFF;  ///< no index: for example, the unit of a symbol in no unit

inline constexpr std::size_t kMaxOperations = 64;       ///< of one unit: they share one word of the image
inline constexpr std::size_t kMaxEvents = 64;           ///< of one unit: they share one word of the image
inline constexpr std::size_t kMaxStates = 250;          ///< of one unit: kNoState and kMovingState are not states
inline constexpr std::size_t kMaxTransitions = 0xFFFE;  ///< of one unit
/// Transition::dt, TypeRow::travel: the time is in the device's rows, at UnitRow::times plus the other bits; without
/// this bit it is in TypeRow::times.
inline constexpr std::uint16_t kOfDevice = 0x8000;
/// The indexes in PlantTables::units of two units with operations in one 64-bit word differ by less than this.
inline constexpr std::uint32_t kMaxUnitsInWord = 255;

/// What a unit does if its operations change while it moves (docs/model.md has the table).
enum class Actuation : std::uint8_t {
  latched,   ///< a robot job: completes every move that it starts
  bistable,  ///< a double solenoid: continues without a command, reverses on the opposite command
  held,      ///< a motor with run contacts: stops without a command
  spring,    ///< a single-acting cylinder: returns to its rest state without a command
};

/// The whole-number parameters of a transition, each 0 if it is not given. kTransitionNumbers lists
/// them: what reads, shows, compares, digests and writes them walks that list.
struct TransitionNumbers {
  std::uint32_t weight = 0;  ///< of the draw among the automatic transitions that are ready

  friend constexpr bool operator==(const TransitionNumbers&, const TransitionNumbers&) noexcept = default;
};

/// A member of TransitionNumbers.
struct TransitionNumber {
  std::string_view key;  ///< in plant.json and in the views; Move has a function of this name
  std::uint32_t TransitionNumbers::*member;
  bool automatic_only;  ///< only the moves of d_int may have it
};
inline constexpr TransitionNumber kTransitionNumbers[] = {{"weight", &TransitionNumbers::weight, true}};

/// One transition between two states. `on` is the operation that commands it, kNoOperation if it is automatic,
/// kSpringReturn if it only gives the travel time of a spring return.
struct Transition {
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  std::uint8_t on = kNoOperation;
  bool once = false;                  ///< firing it disarms its operation (latched units only)
  std::uint16_t when = kNoCondition;  ///< index among its unit's conditions (ConditionedUnit)
  /// The engine keeps a record of it: in some unit of the type its `after` is not a fixed 0, one of its times is
  /// random, it has a number, or the unit has a custom behavior.
  bool timed = false;
  std::uint16_t dt = 0;  ///< which of the TransitionTimes: an index in TypeRow::times, or kOfDevice and an index
  std::uint16_t during = kNoCondition;  ///< `while`, as `when`: the move stops while it does not hold
  TransitionNumbers numbers{};
};

/// How long a transition's cause must hold before the unit leaves the state, and the travel time, both in nanoseconds,
/// >= 0. A negative number n refers to a random time: PlantTables::random_times[-1 - n].
struct TransitionTimes {
  Time after;
  Time takes;
};

/// A time that is drawn each time it is needed (docs/model.md, "One instant").
struct RandomTime {
  enum class Kind : std::uint8_t {
    uniform,  ///< on [a, b], both >= 0, a <= b
    normal,   ///< mean a >= 0, standard deviation b >= 0, cut at 0
    seconds,  ///< of a transition: not drawn, but the result of formula a of ValueTables::formulas
  };
  Kind kind;
  Time a;
  Time b;
};

/// Events that are switched together, one bit each (bit 0: the unit's first event); no bit is in both masks.
struct EventMasks {
  std::uint64_t on;
  std::uint64_t off;
};

/// The structure that all devices of one type share. Its states, operations and events are numbered from 0.
struct TypeRow {
  std::uint8_t operations;
  std::uint8_t events;
  std::uint8_t states;
  std::uint8_t rest;  ///< the state that a spring returns to; kNoState if the actuation is not `spring`
  Actuation actuation;
  std::span<const Transition> transitions;          ///< in priority order: of several that are ready the first fires
  std::span<const EventMasks> enter;                ///< l_enter: a state -> the events it switches
  std::span<const EventMasks> leave;                ///< l_leave: a state -> the events it switches
  std::span<const std::uint8_t> operation_targets;  ///< an operation -> the state of the same name, or kNoState
  std::span<const TransitionTimes> times;           ///< those that all its devices share; Transition::dt is an index
  std::uint16_t travel = 0;  ///< of a move without a transition: which of the TransitionTimes, as Transition::dt
};

/// One unit: its type, its initial state, the positions of its bits in the planes, its times.
struct UnitRow {
  std::uint32_t type : 23;
  std::uint32_t initial : 8;
  /// The engine keeps a GeneralRow of it: it has conditions or a custom behavior, a condition watches it, it disables
  /// a unit or is disabled by one, or its type has a `timed` transition. Other units take the fast path.
  std::uint32_t general : 1;
  std::uint32_t operation_bit;  ///< of its operation 0; all its operations lie in one 64-bit word
  std::uint32_t event_bit;      ///< of its event 0; all its events lie in one 64-bit word
  std::uint32_t times;          ///< index in PlantTables::times of the first time that is its own (kOfDevice)
};
static_assert(sizeof(UnitRow) == 16);

/// `unit` cannot move while `by` is settled in `state` (l_disable). A unit does not disable itself.
struct DisableRow {
  std::uint32_t by;
  std::uint32_t unit;
  std::uint8_t state;
};

/// The kind of row that reads a condition's truth.
enum class ReaderKind : std::uint8_t {
  unit,
  condition,
  requirement,
  follow,
  drive,
  stop,
  end,
  transfer,
  work,
  source,
  malfunction,
  change,         ///< of a value
  formula_input,  ///< a truth in a formula
};

/// A condition of at most six inputs as a truth table: bit i of `truth` is its value if input k is bit k of i. A
/// condition with more inputs is a network of rows, in which one condition reads another.
struct ConditionRow {
  std::uint64_t truth;
  std::uint32_t reader;  ///< index of the row, in the table of its kind
  /// The input number in a condition. In a requirement 0 is `never` or `after`, 1 is `expect`; in a drive 0 is
  /// `forward`, 1 is `backward`; in a malfunction 0 is `when`, 1 is `unless`; else 0.
  std::uint8_t reader_input;
  ReaderKind reader_kind;
};

/// A unit that reads conditions. They are contiguous from `first_condition`: first those of its transitions, then the
/// inputs of its custom behavior.
struct ConditionedUnit {
  std::uint32_t unit;
  std::uint32_t first_condition;
};

inline constexpr std::uint8_t kMovingState = 0xFE;  ///< UnitWatch::state of `DEVICE.moving`

/// Input `input` of `condition` is whether `unit` is settled in `state`, or moving.
struct UnitWatch {
  std::uint32_t unit;
  std::uint32_t condition;
  std::uint8_t state;
  std::uint8_t input;
};

/// Input `input` of `condition` is a bit of the operations' or events' plane, after forces.
struct BitWatch {
  std::uint32_t bit;
  std::uint32_t condition;
  std::uint8_t input;
};

/// Input `input` of `condition` is the comparison of a numeric symbol, after forces, with `operand`; or of a number of
/// parts, whose PartCounterRow is `slot`.
struct ValueWatch {
  std::uint64_t operand;
  std::uint32_t slot;
  std::uint32_t condition;
  std::uint8_t input;
  Comparison comparison;
  NumberKind kind;
};

/// `never`: a condition must not hold. `expect`: after one condition begins to hold, another must hold within a time.
struct RequirementRow {
  enum class Kind : std::uint8_t { never, expect };
  Kind kind = Kind::never;
  std::uint32_t condition = 0;  ///< of `never`, or of `after`
  std::uint32_t expected = 0;   ///< the condition of `expect`; unused for `never`
  Time within = 0;              ///< >= 0
  Time earliest = 0;            ///< `expected` must not hold before; 0 to `within`
};

/// A BOOL event that no unit drives and that is on while a condition holds. With `off` it is switched on while
/// `condition` holds and off while `off` holds, which has priority; it starts off.
struct FollowRow {
  std::uint32_t symbol = 0;
  std::uint32_t condition = 0;
  std::uint32_t off = kNone;  ///< a condition; kNone: none
};

/// A `held` unit for which a command to the state that it has reached is a finding after this time.
struct OverrunRow {
  std::uint32_t unit;
  Time after;  ///< >= 0
};

/// A unit with a custom behavior. `name` is the index of its class in PlantTables::behaviour_names.
struct BehaviourUnit {
  std::uint32_t unit;
  std::uint32_t name;
  std::uint32_t first_input;  ///< of its inputs, among its conditions (ConditionedUnit)
  std::uint32_t input_count;
  std::uint32_t first_value;  ///< of its numeric symbols, in PlantTables::behaviour_values
  std::uint32_t value_count;
};

/// IEC 61131-3 elementary types that an I/O symbol may have. The order is fixed: files and digests hold the numbers.
enum class DataType : std::uint8_t {
  boolean,
  sint,
  int_,
  dint,
  lint,
  usint,
  uint,
  udint,
  ulint,
  byte,
  word,
  dword,
  lword,
  real,
  lreal,
};

/// Seen from the PLC: it writes operations, it reads events.
enum class Direction : std::uint8_t { operation, event };

/// How a symbol's address gives its number on a link.
enum class AddressForm : std::uint8_t {
  none,      ///< no address: the symbol is not on a link
  number,    ///< a plain number (X0001, %IX1, %IW5), or byte.bit (%IX0.1), whose number is 8 * byte + bit
  other,     ///< an address without a number: on a link such symbols are packed in list order
  internal,  ///< an address in the memory of the PLC: on a link such symbols come after those with a number
};

/// Data type, direction, address form and the flags SymbolRow::moved() and inverted(), packed into one number: a table
/// of numbers compiles in two thirds of the time of a table of names (docs/decisions/0003-generated-files.md).
enum class SymbolKind : std::uint32_t {};

constexpr SymbolKind symbol_kind(DataType type, Direction direction, AddressForm form, bool moved,
                                 bool inverted = false) noexcept {
  return static_cast<SymbolKind>(static_cast<std::uint32_t>(type) | static_cast<std::uint32_t>(direction) << 8 |
                                 static_cast<std::uint32_t>(form) << 16 | (moved ? 1U : 0U) << 24 |
                                 (inverted ? 1U : 0U) << 25);
}

/// One I/O symbol, part of a unit or not. Rows are in the order of the lists, and within a list in the order of its
/// lines.
struct SymbolRow {
  std::uint32_t index;   ///< BOOL: its bit in its direction's bit plane; else its slot in that direction's value plane
  std::uint32_t unit;    ///< the unit that it is an operation or event of, or kNone
  std::uint32_t number;  ///< of its address; valid only with AddressForm::number
  std::uint32_t row;     ///< line in the symbol list, counted from 1
  SymbolKind kind;

  constexpr DataType type() const noexcept { return static_cast<DataType>(part(0)); }
  constexpr Direction direction() const noexcept { return static_cast<Direction>(part(8)); }
  constexpr AddressForm form() const noexcept { return static_cast<AddressForm>(part(16)); }
  /// Whether it is an event that its unit, a condition or a sensor of parts drives, or an operation that moves its
  /// unit.
  constexpr bool moved() const noexcept { return (part(24) & 1) != 0; }
  /// Whether its bit has the opposite meaning: on in the planes of Plant while its unit sees it off, and the reverse.
  constexpr bool inverted() const noexcept { return (part(24) & 2) != 0; }

 private:
  constexpr std::uint32_t part(int shift) const noexcept { return (static_cast<std::uint32_t>(kind) >> shift) & 0xFF; }
};

/// One symbol list: its symbols end where those of the next list begin. A list may be empty.
struct SymbolListRow {
  std::uint32_t first_symbol;
  std::uint32_t controller;  ///< the controller of its addresses: index in PlantTables::controller_names
};

/// An initial value other than off or zero, of a bit or slot that no unit sets at the start. A BOOL symbol is on as a
/// unit would see it: an inverted one with 1 starts with its bit off. Integers are in two's complement; REAL and LREAL
/// are the bits of a double.
struct InitialValue {
  std::uint32_t symbol;
  std::uint64_t value;
};

/// A symbol with the same address as another; the engine keeps their values equal.
struct SharedAddress {
  std::uint32_t symbol;
  std::uint32_t leader;  ///< the symbol whose value the other follows
};

/// A whole plant. Texts are in blobs, in the order of their rows; a NUL, which no name contains, ends each text.
struct PlantTables {
  std::string_view name;
  std::span<const TypeRow> types;
  std::span<const UnitRow> units;
  std::span<const TransitionTimes> times;
  std::span<const RandomTime> random_times;
  std::span<const SymbolRow> symbols;
  std::span<const SymbolListRow> lists;  ///< sorted by first symbol; the first begins at 0
  std::span<const InitialValue> initial_values;
  std::span<const SharedAddress> shared_addresses;
  std::span<const DisableRow> disables;  ///< sorted by `by`, `state`, `unit`; no duplicates
  std::span<const ConditionRow> conditions;
  std::span<const ConditionedUnit> conditioned_units;   ///< sorted by unit
  std::span<const UnitWatch> unit_watches;              ///< sorted by unit
  std::span<const BitWatch> operation_watches;          ///< sorted by bit
  std::span<const BitWatch> event_watches;              ///< sorted by bit
  std::span<const ValueWatch> operation_value_watches;  ///< sorted by slot
  std::span<const ValueWatch> event_value_watches;      ///< sorted by slot
  std::span<const RequirementRow> requirements;
  std::span<const FollowRow> follows;    ///< sorted by symbol
  std::span<const OverrunRow> overruns;  ///< sorted by unit
  MaterialTables material;
  std::span<const ValueWatch> part_watches;  ///< sorted by slot
  MalfunctionTables malfunctions;
  ValueTables values;
  std::span<const BehaviourUnit> behaviour_units;   ///< sorted by unit
  std::span<const std::uint32_t> behaviour_values;  ///< indexes of symbols
  std::uint32_t operation_bits;                     ///< size of the bit planes, in bits: a multiple of 64
  std::uint32_t event_bits;
  std::uint32_t operation_slots;  ///< size of the value planes, in 64-bit slots
  std::uint32_t event_slots;
  std::string_view unit_names;         ///< a unit: its path
  std::string_view state_names;        ///< a type: each of its states
  std::string_view symbol_names;       ///< a symbol: its name, then its address as in the list (may be empty)
  std::string_view requirement_names;  ///< a requirement: its name
  std::string_view behaviour_names;    ///< a custom behavior: the name of its class
  std::string_view list_names;         ///< a symbol list: its file name, for messages
  std::string_view controller_names;   ///< a controller: its name, empty for the default controller
};

}  // namespace symplant::tables
