// What a plant is made of: plain rows, the same for generated code and for tables made at run time.
//
// Nothing here changes while a plant runs. Rows refer to each other by index; the one who made the tables keeps
// them alive for as long as a plant uses them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/core/time.hpp"

namespace symplant::core {

inline constexpr std::uint8_t kNoState = 0xFF;
inline constexpr std::uint8_t kNoOperation = 0xFF;
inline constexpr std::uint32_t kNoUnit = 0xFFFF'FFFF;

inline constexpr std::size_t kMaxOperations = 64;  ///< of one unit: they share one word of the image
inline constexpr std::size_t kMaxEvents = 64;      ///< of one unit
inline constexpr std::size_t kMaxStates = 250;     ///< of one unit, so that kNoState is none of them

/// What a unit does while it moves and its operations change (docs/model.md tells the table).
enum class Actuation : std::uint8_t {
  latched,  ///< a robot job: once started it goes on
  spring,   ///< a single-acting cylinder: without a command it returns to its rest state
};

/// One way from a state to another. `on` is the operation that commands it, kNoOperation where it is automatic.
struct Transition {
  std::uint8_t from;
  std::uint8_t to;
  std::uint8_t on;
};

/// How long a transition's cause must hold before it leaves, and how long it then travels, in nanoseconds, >= 0.
struct TransitionTimes {
  Time after;
  Time takes;
};

/// The structure that devices of one type share. States, operations and events are numbered from 0 within it.
struct TypeRow {
  std::uint8_t operations;
  std::uint8_t events;
  std::uint8_t states;
  std::uint8_t rest;  ///< the state a spring returns to; kNoState where the actuation is not `spring`
  Actuation actuation;
  std::span<const Transition> transitions;          ///< in their order: of several that are ready the first fires
  std::span<const std::uint64_t> enter;             ///< l_enter: a state -> the events it sets on, a bit each
  std::span<const std::uint64_t> leave;             ///< l_leave: a state -> the events it sets off, a bit each
  std::span<const std::uint8_t> operation_targets;  ///< an operation -> the state of its own name, or kNoState
};

/// One unit: its type, where its bits lie in the planes, its times and the state it starts in.
struct UnitRow {
  std::uint32_t type;
  std::uint32_t operation_bit;  ///< of its operation 0; all its operations lie in one 64-bit word
  std::uint32_t event_bit;      ///< of its event 0; all its events lie in one 64-bit word
  std::uint32_t times;  ///< of its first entry in PlantTables::times: the default travel, then a transition each
  std::uint8_t initial;
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

/// One I/O symbol, modelled or not. Rows stand in the order of the symbol list.
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
  std::span<const SymbolRow> symbols;
  std::span<const InitialValue> initial_values;
  std::span<const SharedAddress> shared_addresses;
  std::uint32_t operation_bits;  ///< size of the bit planes, in bits: a multiple of 64
  std::uint32_t event_bits;
  std::uint32_t operation_slots;  ///< size of the value planes, in 64-bit slots
  std::uint32_t event_slots;
  std::string_view unit_names;    ///< a unit: its path
  std::string_view state_names;   ///< a type: each of its states
  std::string_view symbol_names;  ///< a symbol: its name, then its address as the list writes it (may be empty)
  std::string_view list;          ///< the symbol list's file name, for messages
};

}  // namespace symplant::core
