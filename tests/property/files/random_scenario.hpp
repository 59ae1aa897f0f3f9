// Random scenarios for a plant, and their results.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// The highest number of instants of one run. A track freezes after 10,000 within a millisecond.
long most_instants(const model::PlantModel& plant);

struct DrawnScenario {
  std::vector<Step> steps;
  std::optional<tables::Time> until;
};

/// Steps for a run with `seed`: most expect the actual values, some do not; a wait may be met at its last instant.
DrawnScenario random_scenario(std::uint64_t draw, std::uint64_t seed, const model::PlantModel& plant);

}  // namespace symplant::property::files
