// From learned times to a model.
#include "property/recordings/learned_model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "learn/learn.hpp"
#include "observe/play.hpp"
#include "watch/shadow.hpp"

namespace symplant::property {
namespace {

using description::Duration;
using learn::LearnedTime;
using learn::LearnedTransition;
using tables::kNone;

void add_statistic(std::uint32_t unit, const LearnedTransition& of, std::uint32_t on, watch::Span span,
                   const LearnedTime& time, std::vector<watch::Statistic>& statistics) {
  const std::vector<tables::Time> durations = [&] {
    std::vector<tables::Time> kept;
    for (const learn::Cluster& cluster : time.clusters.kept) {
      for (std::size_t i = cluster.begin; i < cluster.end; ++i) kept.push_back(time.samples[i].duration);
    }
    return kept;
  }();
  if (durations.size() < 2) return;
  double sum = 0;
  for (const tables::Time duration : durations) sum += static_cast<double>(duration);
  const double n = static_cast<double>(durations.size());
  double squares = 0;
  for (const tables::Time duration : durations) squares += std::pow(static_cast<double>(duration) - sum / n, 2);
  statistics.push_back({unit, of.from, of.to, on, span, durations.size(), sum / n, std::sqrt(squares / (n - 1))});
}

void take(model::Unit& unit, std::uint32_t number, const LearnedTransition& learned,
          std::vector<watch::Statistic>& statistics) {
  std::uint32_t on = kNone;
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
    if (!returns) on = transition.on;
    if (learned.after && !returns) transition.after = learned.after->proposed;
    if (learned.resets_after) transition.after = Duration::fixed(0);
    if (learned.takes) transition.takes = learned.takes->proposed;
    if (learned.resets_takes) transition.takes = Duration::fixed(0);
  }
  if (learned.after) add_statistic(number, learned, on, watch::Span::after, *learned.after, statistics);
  const bool from_lit = unit.states[learned.from].event != kNone;
  const watch::Span span = from_lit ? watch::Span::takes : watch::Span::total;
  if (learned.takes) add_statistic(number, learned, on, span, *learned.takes, statistics);
}

}  // namespace

LearnedModel learned_model(const model::PlantModel& described, recording::Recording recording,
                           const model::PlantModel* rest) {
  observe::Matched matched = observe::match(described, recording);
  std::vector<learn::Input> inputs;
  inputs.push_back({std::move(recording), std::move(matched)});
  const learn::Learned learned = learn::learn_times(described, inputs);
  LearnedModel model{rest == nullptr ? described : *rest, {}};
  for (const learn::LearnedGroup& group : learned.groups) {
    for (const std::uint32_t unit : group.units) {
      for (const LearnedTransition& transition : group.times.transitions) {
        take(model.plant.units[unit], unit, transition, model.statistics);
      }
    }
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
