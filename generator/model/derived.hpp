// The result of the derivation: the model and the evidence.
#pragma once

#include "elements/material/entries.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

struct Derived {
  PlantModel plant;
  Evidence evidence;
  MadeMaterial material{};  ///< with the names of matched devices, not resolved; PlantModel::material is resolved
};

}  // namespace symplant::model
