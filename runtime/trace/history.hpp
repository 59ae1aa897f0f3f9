// The current values of symbols and states of units, and their latest changes, from the records of a run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::trace {

/// Updated by the thread that drains a recorder; does not access the plant. `names` must outlive it.
class History {
 public:
  explicit History(const PlantNames& names);

  /// O(1).
  void apply(const Record& record);

  std::uint64_t value(std::uint32_t symbol) const { return values_[symbol]; }
  plant::UnitView unit(std::uint32_t unit) const { return unpack_unit(units_[unit]); }
  /// Time of its latest change; 0 if it never changed.
  tables::Time since(std::uint32_t symbol) const { return changed_[symbol]; }
  tables::Time unit_since(std::uint32_t unit) const { return unit_changed_[unit]; }
  /// Time at which it last came on; -1: never.
  tables::Time rose(std::uint32_t symbol) const { return rose_[symbol]; }

  /// The operations of a unit that have been on, the latest first; at most `most`.
  std::vector<std::uint32_t> last_operations(std::uint32_t unit, std::size_t most) const;

 private:
  const PlantNames& names_;
  std::vector<std::uint64_t> values_;
  std::vector<tables::Time> changed_;
  std::vector<tables::Time> rose_;
  std::vector<std::uint32_t> units_;  ///< pack_unit
  std::vector<tables::Time> unit_changed_;
};

}  // namespace symplant::trace
