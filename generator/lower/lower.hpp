// The one lowering: from the plant model to the engine's tables.
#pragma once

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// `emit` writes these tables out, `run` hands them to the engine as they are. O(symbols + units + conditions).
EngineTables lower(const model::PlantModel& plant);

}  // namespace symplant::lower
