// What stood where, and since when: the state of a plant as its records tell it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::trace {

/// Kept up by the thread that drains a recorder, apart from the plant. `names` must outlive it.
class History {
 public:
  explicit History(const PlantNames& names);

  /// O(1).
  void apply(const Record& record);

  std::uint64_t value(std::uint32_t symbol) const { return values_[symbol]; }
  plant::UnitView unit(std::uint32_t unit) const { return unpack_unit(units_[unit]); }
  /// Since when it is so; 0 where it never changed.
  tables::Time since(std::uint32_t symbol) const { return changed_[symbol]; }
  tables::Time unit_since(std::uint32_t unit) const { return unit_changed_[unit]; }
  /// When it last came on; -1: never.
  tables::Time rose(std::uint32_t symbol) const { return rose_[symbol]; }

  /// The operations of a unit that have been on, the last to come on first; at most `most`.
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
