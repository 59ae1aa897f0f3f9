// The formulas of times.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "model/condition_reader.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Resolves the formulas of times and collects them in PlantModel::time_formulas. Equal ones are shared. What it is
/// made with must outlive it.
class TimeFormulas {
 public:
  TimeFormulas(PlantModel& plant, ConditionReader& conditions, MadeNames& made)
      : plant_(plant), conditions_(conditions), made_(made) {}

  /// Resolves the formula of a unit's time, which the entry at `here` gives; another time stays as it is. `pattern` is
  /// the name or pattern of the entry. False, and a fault or an entry of MadeNames, if the formula is not valid.
  bool resolve(const Unit& unit, std::string_view pattern, const description::Pointer& here,
               description::Duration& time);

 private:
  PlantModel& plant_;
  ConditionReader& conditions_;
  MadeNames& made_;
  std::unordered_map<std::string, tables::Time> indexes_;  // by text
};

}  // namespace symplant::model
