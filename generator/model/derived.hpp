// The result of the derivation: the model and the evidence.
#pragma once

#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

struct Derived {
  PlantModel plant;
  Evidence evidence;
};

}  // namespace symplant::model
