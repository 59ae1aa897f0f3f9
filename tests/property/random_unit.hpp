// The plan of a random plant, before it becomes a list and a description.
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
  std::vector<std::string> commands;  ///< operations that are not states
  std::vector<std::string> signals;   ///< events that are not states
  std::vector<std::string> added;     ///< states that no symbol names
  std::vector<PlannedValue> values;
  bool behaves = false;  ///< has a behavior of the test

  std::vector<std::string> states() const;      ///< as far as planned
  std::vector<std::string> operations() const;  ///< tasks of operations, commands included
  std::vector<std::string> events() const;      ///< tasks of events, signals included
};

/// Bits and numbers that belong to no unit, or to no planned unit.
struct PlannedPlant {
  std::vector<PlannedUnit> units;
  std::vector<std::string> spare_bits;
  std::vector<PlannedValue> spare_values;
  std::vector<std::string> followers;  ///< events that follow a condition
  bool plain = false;                  ///< no `while`, no weights: more units take the fast path
};

PlannedUnit random_unit(Dice& dice, std::size_t number);
PlannedValue random_value(Dice& dice, std::string name, bool operation);

/// The rows of the plan, with addresses, some shared; in any order.
std::vector<Row> random_rows(Dice& dice, const PlannedPlant& plan);

/// The description of the plan with these rows.
description::Description random_description(Dice& dice, const PlannedPlant& plan, const std::vector<Row>& rows);

/// Names of BOOL rows, each with a chance, some as patterns.
std::vector<std::string> random_inverted(Dice& dice, const std::vector<Row>& rows);

description::Sequence random_sequence(Dice& dice);
/// A duration for `overrun`, or kNever.
tables::Time random_overrun(Dice& dice);

/// A condition over the plan, from the view of one of its units.
std::string random_condition(Dice& dice, const PlannedPlant& plan, const PlannedUnit& own);

/// From a small grid, so that coincidences are frequent.
tables::Time random_time(Dice& dice);
description::Duration random_duration(Dice& dice);

}  // namespace symplant::property
