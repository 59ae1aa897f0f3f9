// Describes the outcome of a scenario.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "symplant/scenario/player.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/explainer.hpp"

namespace symplant::scenario {

/// The number of expectations, by outcome: that of a repeated step counts once a turn. A step that only acts counts if
/// something of it was refused, or it was not reached; it never counts as held.
struct Verdict {
  std::uint64_t held = 0;
  std::uint64_t failed = 0;
  std::uint64_t unreached = 0;
};
Verdict verdict_of(const Scenario& scenario, std::span<const Outcome> outcomes);

/// The expectation of a step as text: `EXLINE_MB_AGV_I_P2 on`, or the condition as in the file; for a wait with its
/// limit.
std::string expectation_words(const Step& step, const trace::PlantNames& names);

/// A step that failed.
struct Failure {
  std::size_t step;
  std::uint64_t turn;  ///< how often the step was done before
  tables::Time time;
  std::span<const std::uint64_t> hands;  ///< what failed by hand: the values of its kHandNotes
};

/// What was expected, and why it is not so; a forced symbol names the step that forces it. Of a conjunction only the
/// parts that do not hold are explained. `history` has the records until that time, `plant` is as for RecordedView.
/// O(steps * depth of repeats) and the explanation.
why::Explanation failure_words(const Scenario& scenario, const Failure& failure, const why::Explainer& explainer,
                               const trace::History& history, const plant::Plant* plant);

}  // namespace symplant::scenario
