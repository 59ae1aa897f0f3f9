// Statistics of a run.
#pragma once

#include <optional>
#include <string>

#include "symplant/host/links.hpp"
#include "symplant/host/outputs.hpp"
#include "symplant/host/plc_clock.hpp"
#include "symplant/host/report.hpp"
#include "symplant/host/run_real.hpp"
#include "symplant/host/why.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::host {

struct StatsInput {
  const plant::Plant& plant;
  std::uint64_t seed = 0;
  const Outputs& outputs;
  const Report& report;
  std::optional<scenario::Verdict> verdict;  ///< only with a scenario
  const std::optional<RealRun>& real_time;   ///< only in real time
  const PlcClockChoice* clock = nullptr;     ///< null: plant time does not follow a PLC's clock
  const Links& links;
  std::span<const Answer> answers;  ///< to `--why`
  const trace::PlantNames& names;
  tables::Time wall = 0;  ///< duration of the run, in ns
};

/// The file of `--stats` with this path: if that ends with `.csv`, the utilization of the plant as a table, else JSON.
std::string stats_text(const std::string& path, const StatsInput& input);

}  // namespace symplant::host
