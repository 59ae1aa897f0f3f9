// Compares engine and reference.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "property/plant_text.hpp"
#include "support/reference/counters.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::property {

/// Counters of a run in addition to the reference's own counters.
struct RunCounts {
  long instants = 0;
  long advances = 0;
  long saves = 0;
  long restores = 0;
  long restores_elsewhere = 0;  ///< into another plant
  long resets = 0;
  long inputs = 0;  ///< set_input calls with an effect
  long inputs_refused = 0;
  long forces = 0;
  long qualities = 0;     ///< set_quality
  long furthers = 0;      ///< further instants that changed nothing
  long malfunctions = 0;  ///< started and stopped from outside
  long values = 0;        ///< set_value calls with an effect
  long values_refused = 0;
  long cut_short = 0;       ///< advances that would run too many instants
  long too_many_rises = 0;  ///< runs ended because more events rose within a cycle than the engine remembers

  RunCounts& operator+=(const RunCounts& other);
};

struct Difference {
  std::size_t action;  ///< the action after which the difference showed; the number of actions if no action caused it
  std::string text;
};

/// Applies the actions to both, compares after every advance, returns the first difference, or nothing. `tables` must
/// be the model's: lowered, or from its generated code.
std::optional<Difference> run_case(const model::PlantModel& plant, const tables::PlantTables& tables,
                                   const std::vector<Action>& actions, bool with_behaviours,
                                   reference::Counters& counters, RunCounts& counts);

/// Builds, lowers and runs. An invalid plant has no difference.
std::optional<Difference> run_case(const Case& the_case, reference::Counters& counters, RunCounts& counts);

}  // namespace symplant::property
