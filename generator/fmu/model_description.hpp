// The description of an FMU: modelDescription.xml.
#pragma once

#include <string>

#include "model/plant_model.hpp"
#include "symplant/fmi/variables.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::fmu {

/// FMI 2.0.4, section 2.2. `identifier` is the name of the library in the FMU. Start values are those of a plant in its
/// initial state. Equal plants give equal texts. O(tables).
std::string model_description(const model::PlantModel& plant, const tables::PlantTables& tables,
                              const fmi::Variables& variables, const std::string& identifier);

}  // namespace symplant::fmu
