// What a run came to, in numbers, as JSON.
#pragma once

#include <optional>
#include <string>

#include "symplant/host/links.hpp"
#include "symplant/host/outputs.hpp"
#include "symplant/host/report.hpp"
#include "symplant/host/run_real.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::host {

struct StatsInput {
  const plant::Plant& plant;
  std::uint64_t seed = 0;
  const Outputs& outputs;
  const Report& report;
  std::optional<scenario::Verdict> verdict;  ///< where a scenario was played
  const std::optional<RealRun>& real_time;   ///< where it was real time
  const Links& links;
  tables::Time wall = 0;  ///< ns that the run took
};

std::string stats_text(const StatsInput& input);

}  // namespace symplant::host
