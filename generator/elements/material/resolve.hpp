// Resolves the names and conditions of the material flow.
#pragma once

#include "description/faults.hpp"
#include "model/derived.hpp"
#include "model/matched_names.hpp"

namespace symplant::model {

/// Fills PlantModel::material from Derived::material; the plant's units must have their states. An entry with `for` is
/// left out for the devices for which the plant lacks what it names.
void resolve_material(Derived& derived, MadeNames& made, description::Faults& faults);

}  // namespace symplant::model
