// From learned times to a model.
#include "property/recordings/learned_model.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "learn/learn.hpp"
#include "observe/play.hpp"
#include "watch/shadow.hpp"

namespace symplant::property {
namespace {

using description::Duration;
using learn::LearnedTransition;
using tables::kNone;

void take(model::Unit& unit, const LearnedTransition& learned) {
  const auto is_return = [&](const model::Transition& t) { return t.from == learned.from && t.to == learned.to; };
  if (learned.transition == kNone && std::none_of(unit.transitions.begin(), unit.transitions.end(), is_return)) {
    model::Transition added;
    added.from = learned.from;
    added.to = learned.to;
    added.spring_return = true;
    added.takes = Duration::fixed(unit.travel);
    unit.transitions.push_back(added);
  }
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    model::Transition& transition = unit.transitions[i];
    const bool returns = learned.transition == kNone;
    if (returns ? transition.from != learned.from || transition.to != learned.to : i != learned.transition) continue;
    if (learned.after && !returns) transition.after = learned.after->proposed;
    if (learned.resets_after) transition.after = Duration::fixed(0);
    if (learned.takes) transition.takes = learned.takes->proposed;
    if (learned.resets_takes) transition.takes = Duration::fixed(0);
  }
}

}  // namespace

LearnedModel learned_model(const model::PlantModel& described, recording::Recording recording) {
  observe::Matched matched = observe::match(described, recording);
  std::vector<learn::Input> inputs;
  inputs.push_back({std::move(recording), std::move(matched)});
  const learn::Learned learned = learn::learn_times(described, inputs);
  LearnedModel model{described, {}};
  for (const learn::LearnedGroup& group : learned.groups) {
    for (const std::uint32_t unit : group.units) {
      for (const LearnedTransition& transition : group.times.transitions) {
        take(model.plant.units[unit], transition);
      }
    }
  }
  static const std::map<std::string_view, watch::Span> spans{
      {"after", watch::Span::after}, {"takes", watch::Span::takes}, {"total", watch::Span::total}};
  for (const learn::Baseline& one : learned.baselines) {
    const std::uint32_t on = one.transition == kNone ? kNone : described.units[one.unit].transitions[one.transition].on;
    model.statistics.push_back({one.unit, one.from, one.to, on, spans.at(one.span), one.count,
                                static_cast<double>(one.mean), static_cast<double>(one.deviation)});
  }
  return model;
}

std::vector<watch::Anomaly> anomalies_of(const LearnedModel& learned, const recording::Recording& recording) {
  std::vector<watch::Anomaly> anomalies;
  const observe::Matched matched = observe::match(learned.plant, recording);
  watch::Shadow shadow(learned.plant, matched.recorded, {.share = 0.2, .resolution = recording.resolution},
                       learned.statistics, [&](const watch::Anomaly& anomaly) { anomalies.push_back(anomaly); });
  watch::follow(recording, matched, shadow);
  return anomalies;
}

}  // namespace symplant::property
