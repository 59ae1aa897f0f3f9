// Lowers the plant model to the engine's tables.
#pragma once

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Makes the tables that `emit` writes as code and that `run` gives to the engine. O(symbols + units + conditions).
EngineTables lower(const model::PlantModel& plant);

}  // namespace symplant::lower
