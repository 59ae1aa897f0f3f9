// The devices and symbols on which malfunctions act.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::trace {

/// Counts the active malfunctions that act on each device and symbol. Used by one thread at a time.
class MalfunctionMarks {
 public:
  /// `tables` must outlive it.
  explicit MalfunctionMarks(const tables::PlantTables& tables)
      : tables_(tables), units_(tables.units.size()), symbols_(tables.symbols.size()) {}

  bool unit(std::uint32_t unit) const { return units_[unit] != 0; }
  bool symbol(std::uint32_t symbol) const { return symbols_[symbol] != 0; }

  /// A malfunction, as tables::MalfunctionNumbers numbers them, started or ended. O(what it acts on).
  void change(std::uint32_t malfunction, bool active);
  /// No malfunction is active any more. O(plant).
  void clear();

 private:
  const tables::PlantTables& tables_;
  std::vector<std::uint32_t> units_;
  std::vector<std::uint32_t> symbols_;
};

/// What a malfunction acts on, as indexes of tables::PlantTables.
struct ActsOn {
  std::vector<std::uint32_t> units;
  std::vector<std::uint32_t> symbols;
};

/// O(what it acts on).
ActsOn acts_on(const tables::PlantTables& tables, std::uint32_t malfunction);

}  // namespace symplant::trace
