// Which times plant.json gives apart from its devices.
#pragma once

#include <vector>

#include "learn/times.hpp"
#include "model/plant_model.hpp"

namespace symplant::learn {

/// The entries of `times` in plant.json: as a rule an earlier result of learning.
class GivenTimes {
 public:
  /// O(units * patterns). The plant must outlive it.
  explicit GivenTimes(const model::PlantModel& plant);

  /// Which times some entry gives the transitions of `moves`. O(times of the device).
  GivenBefore of(std::uint32_t unit, const TransitionMoves& moves) const;

 private:
  const model::PlantModel& plant_;
  std::vector<std::vector<const description::GivenTimes*>> by_unit_;
};

}  // namespace symplant::learn
