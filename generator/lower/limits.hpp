// What the engine's tables cannot hold.
#pragma once

#include <cstdint>
#include <string>

#include "diag/diagnostic.hpp"
#include "lower/engine_tables.hpp"

namespace symplant::lower {

/// Types are numbered with 23 bits.
inline constexpr std::uint64_t kMaxTypes = (std::uint64_t{1} << 23) - 1;
/// Bits of a plane.
inline constexpr std::uint64_t kMaxBits = (std::uint64_t{1} << 31) - 1;

struct Sizes {
  std::uint64_t types;
  std::uint64_t operation_bits;
  std::uint64_t event_bits;
};

/// What of it passes the limits, in words; empty where nothing does.
std::string beyond_limits(const Sizes& sizes);

/// SP701 plant-too-large.
extern const diag::RuleInfo kPlantTooLarge;

/// Tells where the tables cannot hold the plant; they are not to be used then.
void check_limits(const EngineTables& tables, diag::Diagnostics& diagnostics);

}  // namespace symplant::lower
