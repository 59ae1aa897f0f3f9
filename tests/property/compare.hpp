// Engine and reference side by side.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "property/plant_text.hpp"
#include "support/reference/counters.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::property {

/// What a run did beyond the reference's own counters.
struct RunCounts {
  long instants = 0;
  long advances = 0;
  long saves = 0;
  long restores = 0;
  long restores_elsewhere = 0;  ///< into another plant
  long resets = 0;
  long inputs = 0;  ///< set_input that did something
  long inputs_refused = 0;
  long forces = 0;
  long qualities = 0;       ///< set_quality
  long cut_short = 0;       ///< advances that would have run too many instants
  long too_many_rises = 0;  ///< runs ended where more events rose within a cycle than the engine remembers

  RunCounts& operator+=(const RunCounts& other);
};

struct Difference {
  std::size_t action;  ///< after which it showed; the number of actions where there is none to blame
  std::string text;
};

/// Does the actions to both and compares after every advance. The first difference, or nothing. `tables` must be the
/// model's: lowered, or of its generated code.
std::optional<Difference> run_case(const model::PlantModel& plant, const tables::PlantTables& tables,
                                   const std::vector<Action>& actions, bool with_behaviours,
                                   reference::Counters& counters, RunCounts& counts);

/// Builds, lowers and runs. A case that is no valid plant has no difference.
std::optional<Difference> run_case(const Case& the_case, reference::Counters& counters, RunCounts& counts);

}  // namespace symplant::property
