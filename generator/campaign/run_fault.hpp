// Runs one fault of a campaign.
#pragma once

#include <vector>

#include "campaign/judge.hpp"
#include "campaign/plan.hpp"

namespace symplant::campaign {

/// What all faults of a campaign have in common.
struct Campaign {
  Setup setup;
  const host::PlantProgram& plant;  ///< with the malfunctions of the campaign
  const PlantFacts& facts;
  const BaseCase& base;
  const std::vector<Fault>& faults;
  std::string command;  ///< repeats a run, without the options of its fault
};

/// The result of a planned run, without what the run shows.
Result result_of(const Campaign& campaign, const Planned& planned);
/// Runs it in this process, which ends if a program crashes, and judges it. O(run).
Result run_fault(const Campaign& campaign, const Planned& planned);

}  // namespace symplant::campaign
