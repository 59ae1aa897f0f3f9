// How the plant uses each I/O symbol: what reads an operation, what drives an event.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::why {

/// What reads an operation without being moved by it.
struct SymbolReader {
  enum class Kind : std::uint8_t {
    unit,         ///< a condition of the unit
    behavior,     ///< the custom behavior of the unit, if the program contains its code
    requirement,  ///< a condition of the requirement
    event,        ///< the condition that drives the event (`follow`)
    track,        ///< a drive, a stop or the end of a track
    transfer,     ///< of parts
    work,         ///< on parts
    source,       ///< of parts
    malfunction,  ///< its `when` or `unless`
    value,        ///< its formula, or the condition of a jump
  };
  Kind kind;
  std::uint32_t
      index;  ///< of a unit, a requirement, a symbol, a malfunction, a value, or a row of tables::MaterialTables

  friend bool operator==(const SymbolReader&, const SymbolReader&) = default;
};

/// What sets an event, or what an operation moves.
struct SymbolDriver {
  enum class Kind : std::uint8_t {
    none,
    unit,       ///< a state, transition or output of the unit
    behavior,   ///< the custom behavior of the unit, if the program contains its code
    condition,  ///< `follow`
    part,       ///< a sensor of parts; `unit` is its location
  };
  Kind kind = Kind::none;
  std::uint32_t unit = tables::kNone;
};

/// Symbols that share an address count as one symbol here: what one of them does, all do.
class SymbolUse {
 public:
  /// O(symbols + watches of conditions).
  explicit SymbolUse(const tables::PlantTables& tables);

  /// The first symbol on its address, or the symbol itself. O(1).
  std::uint32_t leader(std::uint32_t symbol) const { return leader_[symbol]; }
  /// What drives an event; for an operation the unit that it moves. O(1).
  SymbolDriver driver(std::uint32_t symbol) const { return drivers_[leader_[symbol]]; }
  /// In the order of their kinds and indexes, each once. O(log symbols).
  std::span<const SymbolReader> readers(std::uint32_t symbol) const;

 private:
  struct Reading {
    std::uint32_t symbol;  ///< the leader of its address
    SymbolReader reader;

    friend bool operator==(const Reading&, const Reading&) = default;
  };

  void find_leaders(const tables::PlantTables& tables);
  void find_drivers(const tables::PlantTables& tables);
  void find_readers(const tables::PlantTables& tables);
  void find_readers_of_numbers(const tables::PlantTables& tables);

  std::vector<std::uint32_t> leader_;  ///< of each symbol; itself if its address has no other
  std::vector<SymbolDriver> drivers_;  ///< of leaders
  std::vector<Reading> readings_;      ///< sorted
  std::vector<SymbolReader> readers_;  ///< of `readings_`, so that those of a symbol are one span
};

}  // namespace symplant::why
