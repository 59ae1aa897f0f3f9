// What a random plant is planned to hold, before it is written down as a list and a description.
#pragma once

#include <string>
#include <vector>

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

struct PlannedTask {
  std::string name;
  bool operation = false;
  bool event = false;
};

struct PlannedValue {
  std::string name;
  std::string type;
  bool operation = false;
};

struct PlannedUnit {
  std::string path;
  std::vector<PlannedTask> tasks;     ///< that name states
  std::vector<std::string> commands;  ///< operations that are to be no states
  std::vector<std::string> signals;   ///< events that are to be no states
  std::vector<std::string> added;     ///< states that no symbol names
  std::vector<PlannedValue> values;
  bool behaves = false;  ///< is to have a behaviour of the test's own

  std::vector<std::string> states() const;      ///< as far as they are planned
  std::vector<std::string> operations() const;  ///< tasks of operations, commands included
  std::vector<std::string> events() const;      ///< tasks of events, signals included
};

/// Bits and numbers that are in no unit, or at least in none that is planned.
struct PlannedPlant {
  std::vector<PlannedUnit> units;
  std::vector<std::string> spare_bits;
  std::vector<PlannedValue> spare_values;
};

PlannedUnit random_unit(Dice& dice, std::size_t number);
PlannedValue random_value(Dice& dice, std::string name, bool operation);

/// The rows of the plan, their addresses given, some shared; in any order.
std::vector<Row> random_rows(Dice& dice, const PlannedPlant& plan);

/// What the user says of the plan.
description::Description random_description(Dice& dice, const PlannedPlant& plan);

/// A condition over the plan, seen from a unit of it.
std::string random_condition(Dice& dice, const PlannedPlant& plan, const PlannedUnit& own);

/// From a small grid, so that coincidences are frequent.
tables::Time random_time(Dice& dice);
description::Duration random_duration(Dice& dice);

}  // namespace symplant::property
