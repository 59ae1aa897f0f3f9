// The generated plants of this test, by their seed.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::property {

struct GeneratedPlant {
  std::uint64_t seed;
  const tables::PlantTables& tables;
};

/// Written by emit_plants.
std::vector<GeneratedPlant> generated_plants();

}  // namespace symplant::property
