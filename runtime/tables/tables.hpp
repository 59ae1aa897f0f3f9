// What a plant is made of: plain rows, the same for generated code and for tables made at run time.
//
// Nothing here changes while a plant runs. Rows refer to each other by index; the one who made the tables keeps
// them alive for as long as a plant uses them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::tables {

inline constexpr std::uint8_t kNoState = 0xFF;
inline constexpr std::uint8_t kNoOperation = 0xFF;   ///< Transition::on of an automatic one
inline constexpr std::uint8_t kSpringReturn = 0xFE;  ///< Transition::on of a spring's own way: never ready by itself
inline constexpr std::uint16_t kNoCondition = 0xFFFF;
inline constexpr std::uint32_t kNoUnit = 0xFFFF'FFFF;

inline constexpr std::size_t kMaxOperations = 64;       ///< of one unit: they share one word of the image
inline constexpr std::size_t kMaxEvents = 64;           ///< of one unit
inline constexpr std::size_t kMaxStates = 250;          ///< of one unit, so that kNoState is none of them
inline constexpr std::size_t kMaxTransitions = 0xFFFE;  ///< of one unit
/// Units with operations in one 64-bit word of the plane lie less than this apart in PlantTables::units.
inline constexpr std::uint32_t kMaxUnitsInWord = 255;

/// What a unit does while it moves and its operations change (docs/model.md tells the table).
enum class Actuation : std::uint8_t {
  latched,   ///< a robot job: once started it goes on
  bistable,  ///< a double solenoid: goes on without a command, turns round on the other one
  held,      ///< a motor with run contacts: stands still without a command
  spring,    ///< a single-acting cylinder: without a command it returns to its rest state
};

/// One way from a state to another. `on` is the operation that commands it, kNoOperation where it is automatic,
/// kSpringReturn where it only says how long a spring's own way takes.
struct Transition {
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  std::uint8_t on = kNoOperation;
  bool once = false;                  ///< firing it disarms its operation (latched units only)
  std::uint16_t when = kNoCondition;  ///< a place among its unit's conditions (ConditionedUnit)
  /// In some unit of the type its `after` is not a fixed 0, or one of its times is random, or there is a behaviour: the
  /// engine keeps a record of it.
  bool timed = false;
};

/// How long a transition's cause must hold before it leaves, and how long it then travels, in nanoseconds, >= 0. A
/// negative number n stands for a random time: PlantTables::random_times[-1 - n].
struct TransitionTimes {
  Time after;
  Time takes;
};

/// A time drawn anew each time that it is needed (docs/model.md, "Random times").
struct RandomTime {
  enum class Kind : std::uint8_t {
    uniform,  ///< on [a, b], both >= 0, a <= b
    normal,   ///< mean a >= 0, standard deviation b >= 0, cut at 0
  };
  Kind kind;
  Time a;
  Time b;
};

/// Events that are switched together, a bit each (bit 0: the unit's first); on and off have none in common.
struct EventMasks {
  std::uint64_t on;
  std::uint64_t off;
};

/// The structure that devices of one type share. States, operations and events are numbered from 0 within it.
struct TypeRow {
  std::uint8_t operations;
  std::uint8_t events;
  std::uint8_t states;
  std::uint8_t rest;  ///< the state a spring returns to; kNoState where the actuation is not `spring`
  Actuation actuation;
  std::span<const Transition> transitions;          ///< in their order: of several that are ready the first fires
  std::span<const EventMasks> enter;                ///< l_enter: a state -> the events it switches
  std::span<const EventMasks> leave;                ///< l_leave, likewise
  std::span<const std::uint8_t> operation_targets;  ///< an operation -> the state of its own name, or kNoState
};

/// One unit: its type, the state it starts in, where its bits lie in the planes, its times.
struct UnitRow {
  std::uint32_t type : 23;
  std::uint32_t initial : 8;
  /// Has conditions or a behaviour, is watched by a condition, disables or is disabled, or its type has a `timed`
  /// transition: the engine keeps a record of it. Plain units cost less.
  std::uint32_t general : 1;
  std::uint32_t operation_bit;  ///< of its operation 0; all its operations lie in one 64-bit word
  std::uint32_t event_bit;      ///< of its event 0; all its events lie in one 64-bit word
  std::uint32_t times;  ///< of its first entry in PlantTables::times: the default travel, then a transition each
};
static_assert(sizeof(UnitRow) == 16);

/// `unit` cannot move while `by` is settled in `state` (l_disable). A unit does not disable itself.
struct DisableRow {
  std::uint32_t by;
  std::uint32_t unit;
  std::uint8_t state;
};

/// Who reads a condition's truth.
enum class ReaderKind : std::uint8_t { unit, condition, requirement };

/// A condition of at most six inputs as a truth table: bit i of `truth` is its value where input k is bit k of i. A
/// condition of more is a network: the reader of the inner ones is a condition.
struct ConditionRow {
  std::uint64_t truth;
  std::uint32_t reader;  ///< a unit, a condition, or a requirement
  std::uint8_t
      reader_input;  ///< of a condition: the input that this one is; of a requirement: 0 `never` or `after`, 1 `expect`
  ReaderKind reader_kind;
};

/// A unit with conditions of its own: they lie side by side from `first_condition`. What transitions want comes first,
/// then the inputs of its behaviour.
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

enum class Comparison : std::uint8_t { less, less_equal, equal, greater_equal, greater };
/// How the 64 bits of a slot are compared.
enum class NumberKind : std::uint8_t { signed_integer, unsigned_integer, real };

/// Input `input` of `condition` is how a numeric symbol compares with `operand`, after forces.
struct ValueWatch {
  std::uint64_t operand;
  std::uint32_t slot;
  std::uint32_t condition;
  std::uint8_t input;
  Comparison comparison;
  NumberKind kind;
};

/// `never` a condition, or `after` one `expect` another `within` a time. Requirement r reads the conditions whose
/// reader it is.
struct RequirementRow {
  enum class Kind : std::uint8_t { never, expect };
  Kind kind;
  std::uint32_t condition;  ///< of `never`, or of `after`
  std::uint32_t expected;   ///< of `expect`; without meaning for `never`
  Time within;              ///< >= 0
};

/// A unit whose class the user has derived from. `name` is its place in PlantTables::behaviour_names.
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
  none,    ///< no address: the symbol is on no link
  number,  ///< a plain index (X0001, %IX1, %IW5), or byte.bit (%IX0.1), whose number is 8 * byte + bit
  other,   ///< has no number of its own on a link: those are packed in list order
};

/// Type, direction, form of the address and whether it is moved, in one number: a compiler takes in a table of numbers
/// in two thirds of the time that it takes for one of names (docs/decisions/0003-generated-files.md).
enum class SymbolKind : std::uint32_t {};

constexpr SymbolKind symbol_kind(DataType type, Direction direction, AddressForm form, bool moved) noexcept {
  return static_cast<SymbolKind>(static_cast<std::uint32_t>(type) | static_cast<std::uint32_t>(direction) << 8 |
                                 static_cast<std::uint32_t>(form) << 16 | (moved ? 1U : 0U) << 24);
}

/// One I/O symbol, modelled or not. Rows stand in the order of the lists, and in that of each list.
struct SymbolRow {
  std::uint32_t index;   ///< BOOL: its bit in its direction's bit plane; else its slot in that direction's value plane
  std::uint32_t unit;    ///< the unit that it is an operation or event of, or kNoUnit
  std::uint32_t number;  ///< of its address, meaningful with AddressForm::number
  std::uint32_t row;     ///< line in the symbol list, counted from 1
  SymbolKind kind;

  constexpr DataType type() const noexcept { return static_cast<DataType>(part(0)); }
  constexpr Direction direction() const noexcept { return static_cast<Direction>(part(8)); }
  constexpr AddressForm form() const noexcept { return static_cast<AddressForm>(part(16)); }
  /// An event that its unit moves, or an operation that moves its unit.
  constexpr bool moved() const noexcept { return part(24) != 0; }

 private:
  constexpr std::uint32_t part(int shift) const noexcept { return (static_cast<std::uint32_t>(kind) >> shift) & 0xFF; }
};

/// One symbol list: its symbols are those from the first up to that of the next list. A list may have none.
struct SymbolListRow {
  std::uint32_t first_symbol;
  std::uint32_t controller;  ///< whose addresses they have: its place in PlantTables::controller_names
};

/// A starting value other than off or zero, of a bit or slot that no unit sets at the start.
/// Integers are in two's complement, REAL and LREAL as the bits of a double.
struct InitialValue {
  std::uint32_t symbol;
  std::uint64_t value;
};

/// A symbol that stands on the address of another; they are kept equal.
struct SharedAddress {
  std::uint32_t symbol;
  std::uint32_t leader;  ///< the symbol whose value the other follows
};

/// A whole plant. Texts lie in blobs, each ended by a NUL (which no name holds), in the order of their rows.
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
  std::span<const DisableRow> disables;  ///< sorted by `by`, `state`, `unit`; none twice
  std::span<const ConditionRow> conditions;
  std::span<const ConditionedUnit> conditioned_units;   ///< sorted by unit
  std::span<const UnitWatch> unit_watches;              ///< sorted by unit
  std::span<const BitWatch> operation_watches;          ///< sorted by bit
  std::span<const BitWatch> event_watches;              ///< sorted by bit
  std::span<const ValueWatch> operation_value_watches;  ///< sorted by slot
  std::span<const ValueWatch> event_value_watches;      ///< sorted by slot
  std::span<const RequirementRow> requirements;
  std::span<const BehaviourUnit> behaviour_units;   ///< sorted by unit
  std::span<const std::uint32_t> behaviour_values;  ///< symbols
  std::uint32_t operation_bits;                     ///< size of the bit planes, in bits: a multiple of 64
  std::uint32_t event_bits;
  std::uint32_t operation_slots;  ///< size of the value planes, in 64-bit slots
  std::uint32_t event_slots;
  std::string_view unit_names;         ///< a unit: its path
  std::string_view state_names;        ///< a type: each of its states
  std::string_view symbol_names;       ///< a symbol: its name, then its address as the list writes it (may be empty)
  std::string_view requirement_names;  ///< a requirement: its name
  std::string_view behaviour_names;    ///< a behaviour: the name of its class
  std::string_view list_names;         ///< a symbol list: its file name, for messages
  std::string_view controller_names;   ///< a controller: its name, which is empty for the default one
};

}  // namespace symplant::tables
