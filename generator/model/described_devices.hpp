// Devices that the description makes of symbols, whatever their names.
#pragma once

#include "description/description.hpp"
#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

class SymbolNames;

/// Sets device and task of the symbols that `operations` and `events` of devices name. Call before symbols are grouped.
/// O(symbols) if the description has any.
void claim_symbols(PlantModel& plant, const description::Description& description, const SymbolNames& names,
                   description::Faults& faults);

}  // namespace symplant::model
