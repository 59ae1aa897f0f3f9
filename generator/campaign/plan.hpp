// The runs of a campaign: each fault, from each time on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/base_case.hpp"
#include "campaign/fault.hpp"

namespace symplant::campaign {

enum class Phases : std::uint8_t {
  start,  ///< from the start
  all,    ///< also from each change of the fault's devices and inputs in the base case
};

/// A fault from a time on.
struct Planned {
  std::size_t fault = 0;  ///< its index
  tables::Time at = 0;
  std::string phase;   ///< `from the start`, `when CLAMP1 leaves OPEN`
  bool needed = true;  ///< false: the fault holds what the base case shows from then on anyway
};

/// All runs, by fault, then by time. O(faults + changes of the base case * faults of one thing).
std::vector<Planned> plan(const std::vector<Fault>& faults, Phases phases, const BaseCase& base,
                          const trace::PlantNames& names);

}  // namespace symplant::campaign
