// What the cycle asks of whatever stands between the plant and a PLC.
#pragma once

#include "symplant/core/plant.hpp"

namespace symplant::exec {

/// One exchange of images with a PLC. Both functions are called by the thread of the cycle, are noexcept and never
/// block; what blocks has a thread of its own behind them.
class Exchange {
 public:
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  virtual ~Exchange() = default;

  /// Hands what the PLC wrote to the plant; called before the plant is advanced.
  virtual void read_operations(core::Plant& plant) noexcept = 0;

  /// Hands the plant's events to the PLC; called after the plant was advanced, and once before the first cycle.
  /// changed_events() of the plant names what changed since the call before.
  virtual void write_events(const core::Plant& plant) noexcept = 0;
};

}  // namespace symplant::exec
