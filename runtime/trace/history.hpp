// The current values of symbols and states of units, and their latest changes, from the records of a run.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"
#include "symplant/trace/zeroed_array.hpp"

namespace symplant::trace {

/// Updated by the thread that drains a recorder; does not access the plant. `names` must outlive it. Takes memory for
/// what has changed, at most 8 bytes for a symbol, 8 more for an operation, and 12 for a unit.
class History {
 public:
  explicit History(const PlantNames& names);

  /// O(1).
  void apply(const Record& record);
  /// Takes all values and states from a plant that was reset or restored. A value that differs, or whose last change is
  /// later than the plant's time, counts as changed at the plant's time. O(plant).
  void load(const plant::Plant& plant);
  /// Notes that a symbol is forced, or no longer. O(log forced).
  void force(std::uint32_t symbol, bool forced, tables::Time time);
  /// Since when a symbol is forced; -1: it is not. O(log forced).
  tables::Time forced_since(std::uint32_t symbol) const;
  const std::map<std::uint32_t, tables::Time>& forced() const { return forced_; }

  /// An active malfunction.
  struct Malfunction {
    std::uint32_t number;  ///< as tables::MalfunctionNumbers numbers them
    tables::Time since;
    engine::MalfunctionChange::By by;  ///< what started it
  };
  /// In the order in which they started.
  const std::vector<Malfunction>& malfunctions() const { return malfunctions_; }
  /// Exchanges them for others.
  void swap_malfunctions(std::vector<Malfunction>& others) { malfunctions_.swap(others); }

  std::uint64_t value(std::uint32_t symbol) const;
  /// An output of a value, as last recorded; before that as at the start. Valid if records show it.
  double output(std::uint32_t output) const { return outputs_[output]; }
  bool shows(std::uint32_t output) const { return traces_[output] != 0; }
  /// Whether an operation commands: it is on, or an inverted one is off; a number is not 0.
  bool commands(std::uint32_t operation) const;
  /// A part at a location.
  struct Part {
    std::uint64_t number;
    std::uint32_t kind;
    tables::Time since;  ///< when it came there
  };
  /// The parts at a location, in the order in which they came.
  const std::vector<Part>& parts_at(std::uint32_t location) const { return parts_[location]; }
  /// A part by its number; null if it is not in the plant. O(parts).
  const Part* part(std::uint64_t number) const;
  plant::UnitView unit(std::uint32_t unit) const { return unpack_unit(units_[unit]); }
  /// Time of its latest change; 0 if it never changed.
  tables::Time since(std::uint32_t symbol) const { return changed_[symbol]; }
  tables::Time unit_since(std::uint32_t unit) const { return unit_changed_[unit]; }
  /// Time at which an operation last began to command; -1: never.
  tables::Time rose(std::uint32_t operation) const { return rose_[risen(operation)] - 1; }

  /// The operations of a unit that have commanded, the latest first; at most `most`.
  std::vector<std::uint32_t> last_operations(std::uint32_t unit, std::size_t most) const;

 private:
  const PlantNames& names_;
  void move_part(const PartRecord& part);
  /// The index of a numeric symbol in `numbers_`.
  std::size_t slot(const tables::SymbolRow& symbol) const;
  /// The index of an operation in `rose_`.
  std::size_t risen(std::uint32_t operation) const;
  void forget_after(tables::Time now);
  void load_symbol(std::uint32_t symbol, const plant::Plant& plant);

  std::vector<bool> bits_;              ///< by symbol, if it is BOOL
  std::vector<std::uint64_t> numbers_;  ///< by slot: operations, then events
  ZeroedArray<tables::Time> changed_;
  ZeroedArray<tables::Time> rose_;    ///< one more than the time: by bit, then by slot of an operation
  std::vector<std::uint32_t> units_;  ///< pack_unit
  ZeroedArray<tables::Time> unit_changed_;
  std::vector<std::vector<Part>> parts_;          ///< by location
  Record part_;                                   ///< the last record of a part, whose part_move is next
  std::map<std::uint32_t, tables::Time> forced_;  ///< a symbol -> since when
  std::vector<Malfunction> malfunctions_;
  std::vector<double> outputs_;       ///< of values
  std::vector<tables::Time> traces_;  ///< as traces_of()
};

}  // namespace symplant::trace
