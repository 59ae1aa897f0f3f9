// How many I/O symbols of a plant are paired and accounted for.
#pragma once

#include <cstddef>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::score {

using name::Account;
using name::Counts;

/// Accounts of the score: `modelled` is an operation that drives an event, or an event that an operation drives.
struct PlantScore {
  Counts total;
  std::vector<Account> accounts;  ///< one for each symbol of the plant
  std::size_t named = 0;          ///< symbols that the naming rule reads
};

/// By the pairing of facets; where each device is one unit, by paired_by_task(). O(symbols).
PlantScore score_of(const model::PlantModel& plant);

}  // namespace symplant::score
