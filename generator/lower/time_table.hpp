// Times of transitions, fixed and random.
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
  /// The first of a unit's entries in EngineTables::times: the default travel, then a transition each. Units of one
  /// type with equal times share them. O(transitions).
  std::uint32_t times_of(std::uint32_t type, const model::Unit& unit, EngineTables& tables);

 private:
  /// As tables::TransitionTimes has it.
  tables::Time lowered(const description::Duration& duration, std::vector<tables::RandomTime>& random_times);

  std::map<std::vector<std::int64_t>, std::uint32_t> by_times_;
  std::vector<std::int64_t> key_;  ///< of the unit at hand
  std::map<std::tuple<tables::RandomTime::Kind, tables::Time, tables::Time>, tables::Time> random_;
};

}  // namespace symplant::lower
