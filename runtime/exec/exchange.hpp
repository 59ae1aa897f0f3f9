// The interface of a link between the plant and a PLC, as the cycle uses it.
#pragma once

#include <cstdint>

#include "symplant/plant/plant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// The state of a link.
enum class LinkState : std::uint8_t {
  waiting,  ///< its PLC has not sent anything yet
  live,
  lost,  ///< its PLC was live and is silent now
};

/// The status of the cycle that links pass on to the PLC.
struct CycleStatus {
  std::uint64_t cycles = 0;    ///< number of cycles before this one
  std::uint64_t overruns = 0;  ///< as in CycleStatistics
  std::uint64_t live = 0;      ///< bit i: link i is live; for the first 64 links
  bool frozen = false;         ///< the plant is frozen, by the policy of a lost link
};

/// The exchange of images with one PLC. The cycle's thread calls all functions; they must not block. Blocking work runs
/// in a separate thread.
class Exchange {
 public:
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  virtual ~Exchange() = default;

  /// Writes the operations from the PLC to the plant; called before the plant is advanced. `now` is the time by which
  /// the link measures the silence of its PLC, in ns: it follows the clock, but a delay of this process counts for two
  /// cycles at most.
  virtual void read_operations(plant::Plant& plant, tables::Time now) noexcept = 0;

  /// Sends the plant's events to the PLC; called after the plant was advanced, and once before the first cycle.
  /// plant.changed_events() has the changes since the previous call.
  virtual void write_events(const plant::Plant& plant, const CycleStatus& status) noexcept = 0;

  /// The last call, at the end of the run. Images stay unchanged.
  virtual void leave() noexcept {}

  /// The state at the last read_operations().
  virtual LinkState state() const noexcept { return LinkState::live; }
  /// Whether the plant must freeze because this link is lost, or still waits for its PLC.
  virtual bool freezes_plant() const noexcept { return false; }
};

}  // namespace symplant::exec
