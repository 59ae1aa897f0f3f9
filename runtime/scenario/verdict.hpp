// What became of a scenario, in words.
#pragma once

#include <span>
#include <string>

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

/// Why a step's expectation failed at `time`: what was expected, what is there and since when, and which operations led
/// to it. `history` is as of that time.
std::string failure_words(const Step& step, core::Time time, const trace::PlantNames& names,
                          const trace::History& history);

}  // namespace symplant::scenario
