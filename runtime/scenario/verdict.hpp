// What became of a scenario, in words.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "symplant/scenario/player.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::scenario {

/// Steps that expect something, by what became of them.
struct Verdict {
  std::size_t held = 0;
  std::size_t failed = 0;
  std::size_t unreached = 0;
};
Verdict verdict_of(const Scenario& scenario, std::span<const Outcome> outcomes);

/// `EXLINE_MB_AGV_I_P2 on`, a condition in its author's words; of a wait with how long.
std::string expectation_words(const Step& step, const trace::PlantNames& names);

/// Why a step's expectation failed at `time`: what was expected, then a part for each symbol and each unit that it
/// names, with what is there, since when, which operation led to it, and which step forces it. Of a conjunction only
/// what does not hold is told. `at` is the step's place, `history` as of that time. Never empty; joined by `; ` they
/// are one sentence. O(steps).
std::vector<std::string> failure_parts(const Scenario& scenario, std::size_t at, tables::Time time,
                                       const trace::PlantNames& names, const trace::History& history);

}  // namespace symplant::scenario
