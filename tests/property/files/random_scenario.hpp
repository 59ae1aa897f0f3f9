// Scenarios that might be played on a plant, and how they come out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// More instants than this are too many for one run.
inline constexpr long kMostInstants = 3000;

struct DrawnScenario {
  std::vector<Step> steps;
  std::optional<tables::Time> until;
};

/// Steps for a run under `seed`: most expect what is there, some do not; a wait may be met at its last instant.
DrawnScenario random_scenario(std::uint64_t draw, std::uint64_t seed, const model::PlantModel& plant);

}  // namespace symplant::property::files
