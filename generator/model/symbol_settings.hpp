// What the description says about single symbols: which are inverted, and which follow a condition.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Sets Symbol::inverted, marks the symbols that follow a condition or show a formula, and fills PlantModel::follows
/// and signals without these. Before the symbols are grouped by device. O(symbols * patterns).
void apply_symbol_settings(PlantModel& plant, const description::Description& description, description::Faults& faults);

/// Reports a `follow` entry that depends on itself through other such entries alone. The conditions must be resolved.
void check_follow_cycles(const PlantModel& plant, description::Faults& faults);

/// The location of an entry of `follow`, by its index.
description::Pointer follow_pointer(const PlantModel& plant, std::uint32_t given);

}  // namespace symplant::model
