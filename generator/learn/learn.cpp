// From recordings to times.
#include "learn/learn.hpp"

#include <utility>

#include "learn/baseline.hpp"
#include "learn/durations.hpp"
#include "learn/explain.hpp"
#include "learn/given_times.hpp"
#include "learn/groups.hpp"
#include "learn/not_seen.hpp"
#include "learn/times.hpp"
#include "learn/unused.hpp"

namespace symplant::learn {
namespace {

void explain_times(const Explainer& explainer, LearnedDevice& device) {
  const auto explain = [&](std::optional<LearnedTime>& time) {
    if (time) time->explanation = explainer.explain(device.unit, *time);
  };
  for (LearnedTransition& transition : device.transitions) {
    explain(transition.after);
    explain(transition.takes);
  }
  explain(device.overrun);
}

/// Whether anything was learned of a transition.
bool is_learned(const LearnedTransition& transition) {
  return transition.after || transition.takes || transition.resets_after || transition.resets_takes;
}

}  // namespace

Learned learn_times(const model::PlantModel& plant, const std::vector<Input>& inputs) {
  const Moves moves = moves_of(plant, inputs);
  Learned learned;
  learned.plant = &plant;
  for (const Input& input : inputs) {
    learned.sources.push_back({input.recording.name, input.recording.end, input.recording.resolution});
  }
  const GivenTimes given(plant);
  const Explainer explainer(plant, inputs, moves);
  std::vector<LearnedDevice> devices;
  for (const UnitMoves& seen : moves.units) {
    LearnedDevice device{seen.unit, {}, {}};
    for (const TransitionMoves& some : seen.transitions) {
      LearnedTransition transition =
          learn_transition(plant.units[seen.unit], some, learned.sources, given.of(seen.unit, some));
      for (const Baseline& baseline : baselines_of(some, learned.sources)) learned.baselines.push_back(baseline);
      if (is_learned(transition)) device.transitions.push_back(std::move(transition));
    }
    if (!seen.overruns.empty()) device.overrun = overrun_time_of(seen.overruns, learned.sources);
    if (device.transitions.empty() && !device.overrun) continue;
    explain_times(explainer, device);
    devices.push_back(std::move(device));
  }
  learned.groups = groups_of(plant, std::move(devices));
  learned.not_seen = not_seen(plant, inputs, moves);
  learned.moves = moves.count;
  learned.unused = moves.unused;
  learned.unused_moves = unused_moves(plant, inputs, moves);
  return learned;
}

}  // namespace symplant::learn
