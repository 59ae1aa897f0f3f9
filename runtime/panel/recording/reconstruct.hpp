// Adds to the records of a trace what it does not hold: the states of devices, and how parts move.
#pragma once

#include <vector>

#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The records with those of Record::Kind::unit and of motions, as a recorder of motions would have them. O(records *
/// log(records)).
std::vector<trace::Record> reconstruct(std::vector<trace::Record> records, const trace::PlantNames& names);

}  // namespace symplant::panel
