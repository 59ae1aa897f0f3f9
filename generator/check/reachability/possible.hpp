// Which states of a plant's units count as possible.
#pragma once

#include <cstdint>

#include "model/plant_model.hpp"

namespace symplant::check {

/// Which states of a plant's units count as possible.
class Possible {
 public:
  virtual ~Possible() = default;
  virtual bool settled(std::uint32_t unit, std::uint32_t state) const = 0;
  virtual bool moving(std::uint32_t unit) const = 0;
};

/// Every state of every unit is possible; a unit may move if a transition takes time.
class AllStates final : public Possible {
 public:
  explicit AllStates(const model::PlantModel& plant) : plant_(plant) {}
  bool settled(std::uint32_t, std::uint32_t) const override { return true; }
  bool moving(std::uint32_t unit) const override;

 private:
  const model::PlantModel& plant_;
};

/// Whether a unit is ever between two states.
bool travels(const model::Unit& unit);

}  // namespace symplant::check
