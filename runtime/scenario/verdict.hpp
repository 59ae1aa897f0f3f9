// Describes the outcome of a scenario.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "symplant/scenario/player.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::scenario {

/// The number of expectations, by outcome: that of a repeated step counts once a turn.
struct Verdict {
  std::uint64_t held = 0;
  std::uint64_t failed = 0;
  std::uint64_t unreached = 0;
};
Verdict verdict_of(const Scenario& scenario, std::span<const Outcome> outcomes);

/// The expectation of a step as text: `EXLINE_MB_AGV_I_P2 on`, or the condition as in the file; for a wait with its
/// limit.
std::string expectation_words(const Step& step, const trace::PlantNames& names);

/// Why a step's expectation failed at `time`: what was expected, then one part for each of its symbols and units: its
/// value or state, since when, the operation that led to it, and the step that forces it. Of a conjunction only the
/// parts that do not hold are reported. `at` is the index of the step, `history` the records at that time. Never empty;
/// join the parts with `; `. `turn` is how often the step was done before. O(steps * depth of repeats).
std::vector<std::string> failure_parts(const Scenario& scenario, std::size_t at, std::uint64_t turn, tables::Time time,
                                       std::span<const std::uint64_t> hands, const trace::PlantNames& names,
                                       const trace::History& history);

}  // namespace symplant::scenario
