// Lowers the times of transitions, fixed and random.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

class TimeTable {
 public:
  /// The index of a unit's first entry in EngineTables::times: the default travel time, then one entry for each
  /// transition. Units of one type with equal times share them. O(transitions).
  std::uint32_t times_of(std::uint32_t type, const model::Unit& unit, EngineTables& tables);

 private:
  /// A duration in the form of tables::TransitionTimes.
  tables::Time lowered(const description::Duration& duration, std::vector<tables::RandomTime>& random_times);

  std::map<std::vector<std::int64_t>, std::uint32_t> by_times_;
  std::vector<std::int64_t> key_;  ///< of the current unit
  std::map<std::tuple<tables::RandomTime::Kind, tables::Time, tables::Time>, tables::Time> random_;
};

}  // namespace symplant::lower
