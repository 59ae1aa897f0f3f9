// Draws the plants for code generation: small ones, without user code.
#pragma once

#include <cstddef>
#include <cstdint>

#include "property/random_plant.hpp"

namespace symplant::property {

inline DrawnPlant draw_generated(std::uint64_t seed) {
  constexpr std::size_t kMostUnits = 6;
  return random_plant(seed, {false, kMostUnits});
}

}  // namespace symplant::property
