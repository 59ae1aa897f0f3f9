// The acts of a run that are neither steps of a scenario nor orders of the panel.
#include "symplant/host/run_acts.hpp"

#include "symplant/scenario/step_text.hpp"

namespace symplant::host {

ActText text_of_run_act(std::uint64_t act, const trace::PlantNames& names) {
  const bool starts = (act >> 62 & 1) != 0;
  const bool by_hand = (act >> 61 & 1) != 0;
  scenario::Step step;
  (starts ? step.start : step.stop).push_back(static_cast<std::uint32_t>(act));
  return {scenario::act_json(step, names), by_hand ? "hand" : "scenario"};
}

}  // namespace symplant::host
