// A model with the times that were learned of it, and what drift is measured against.
#pragma once

#include <vector>

#include "learn/learned.hpp"
#include "model/plant_model.hpp"
#include "recording/recording.hpp"
#include "watch/anomaly.hpp"
#include "watch/statistics.hpp"

namespace symplant::property {

struct LearnedModel {
  model::PlantModel plant;
  std::vector<watch::Statistic> statistics;
};

/// What a description that includes the learned times gives.
LearnedModel learned_model(const model::PlantModel& described, recording::Recording recording);

/// The anomalies of a recording, with the margin that `symplant watch` has by default.
std::vector<watch::Anomaly> anomalies_of(const LearnedModel& learned, const recording::Recording& recording);

}  // namespace symplant::property
