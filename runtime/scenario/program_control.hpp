// What scenarios and the panel do with the PLC programs of a run.
#pragma once

#include <cstdint>

namespace symplant::scenario {

/// Called in the thread that runs the plant, between instants.
class ProgramControl {
 public:
  /// A cold start of the program of a controller: its operations go to zero until the writes of its next scan are
  /// sampled. False if the controller has no program.
  virtual bool restart(std::uint32_t controller) noexcept = 0;
  /// The plant was reset: all programs begin again.
  virtual void reset() noexcept = 0;

 protected:
  ~ProgramControl() = default;
};

}  // namespace symplant::scenario
