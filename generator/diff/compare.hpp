// Compares two plants.
#pragma once

#include "diff/difference.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::diff {

/// A plant to be compared. `tables` is null if the plant has errors: then its model hash is not compared.
struct Side {
  const model::PlantModel& plant;
  const lower::EngineTables* tables = nullptr;
};

/// What changed from `before` to `after`. Rows without a name are left out. O(n log n) in rows and parts of models.
Difference compare(const Side& before, const Side& after);

}  // namespace symplant::diff
