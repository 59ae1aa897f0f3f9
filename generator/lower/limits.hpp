// The limits of the engine's tables.
#pragma once

#include <cstdint>
#include <string>

#include "diag/diagnostic.hpp"
#include "lower/engine_tables.hpp"

namespace symplant::lower {

/// Types are numbered with 23 bits.
inline constexpr std::uint64_t kMaxTypes = (std::uint64_t{1} << 23) - 1;
/// The most bits of a plane.
inline constexpr std::uint64_t kMaxBits = (std::uint64_t{1} << 31) - 1;

struct Sizes {
  std::uint64_t types;
  std::uint64_t operation_bits;
  std::uint64_t event_bits;
};

/// A message about the first size beyond its limit; empty if there is none.
std::string beyond_limits(const Sizes& sizes);

/// SP701 plant-too-large.
extern const diag::RuleInfo kPlantTooLarge;

/// Reports if the tables cannot hold the plant; then they must not be used.
void check_limits(const EngineTables& tables, diag::Diagnostics& diagnostics);

}  // namespace symplant::lower
