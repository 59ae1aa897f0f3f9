// What the cycle asks of whatever stands between the plant and a PLC.
#pragma once

#include <cstdint>

#include "symplant/plant/plant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// How a link stands.
enum class LinkState : std::uint8_t {
  waiting,  ///< its PLC has not been heard yet
  live,
  lost,  ///< its PLC was heard and is silent
};

/// What the cycle tells its links, for the PLC programmer.
struct CycleStatus {
  std::uint64_t cycles = 0;    ///< ended before this one
  std::uint64_t overruns = 0;  ///< as CycleStatistics counts them
  std::uint64_t live = 0;      ///< bit i: link i is live; of the first 64 links
  bool frozen = false;         ///< the plant stands still, as a lost link's policy says
};

/// One exchange of images with a PLC. Both functions are called by the thread of the cycle, are noexcept and never
/// block; what blocks has a thread of its own behind them.
class Exchange {
 public:
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  virtual ~Exchange() = default;

  /// Hands what the PLC wrote to the plant; called before the plant is advanced. `now` is a time by which a link knows
  /// how long its PLC is silent: the clock's, but where this process stood still that counts for two cycles at most.
  virtual void read_operations(plant::Plant& plant, tables::Time now) noexcept = 0;

  /// Hands the plant's events to the PLC; called after the plant was advanced, and once before the first cycle.
  /// changed_events() of the plant names what changed since the call before.
  virtual void write_events(const plant::Plant& plant, const CycleStatus& status) noexcept = 0;

  /// The run ends: the last call. Images stay as they are.
  virtual void leave() noexcept {}

  /// As the last read_operations() found it.
  virtual LinkState state() const noexcept { return LinkState::live; }
  /// Whether the plant is to stand still, since this link is lost.
  virtual bool freezes_plant() const noexcept { return false; }
};

}  // namespace symplant::exec
