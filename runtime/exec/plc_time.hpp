// Reads the counter of a PlcClock from the plant, once per cycle.
#pragma once

#include <cstdint>

#include "symplant/exec/exchange.hpp"
#include "symplant/exec/plc_clock.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::exec {

/// Plant time by a numeric operation that a PLC counts up. Values count only while the link is live; after a loss the
/// first one restarts the clock. For the cycle's thread.
class PlcTime {
 public:
  /// `slot`: of the operation. The link must outlive this object. The value that the operation has now does not count:
  /// the PLC has not written it.
  PlcTime(const PlcClockOptions& options, const plant::Plant& plant, std::uint32_t slot, const Exchange& link) noexcept;
  PlcTime(const PlcTime&) = delete;
  PlcTime& operator=(const PlcTime&) = delete;
  virtual ~PlcTime() = default;

  /// The plant time of this cycle, after the links' reads; `cycles`: since the last call. O(1).
  tables::Time next(const plant::Plant& plant, std::int64_t cycles) noexcept;
  /// Instead of next() in a cycle in which the plant is frozen: its time is not caught up.
  void hold(const plant::Plant& plant) noexcept;

  const PlcClockReading& reading() const noexcept { return clock_.reading(); }
  /// Whether plant time cannot run: the counter has not counted yet, or the link is not live. A counter that has
  /// counted and pauses is a PLC at a breakpoint: plant time waits for it, but this is false.
  bool is_without_plc() const noexcept { return !reading().has_counted() || link_.state() != LinkState::live; }

 protected:
  /// Called when the PLC's clock has restarted.
  virtual void restarted(const plant::Plant& /*plant*/) noexcept {}

 private:
  void follow_link(const plant::Plant& plant) noexcept;

  PlcClock clock_;
  const Exchange& link_;
  std::uint32_t slot_;
  std::uint64_t value_;  ///< the last one
  bool was_lost_ = false;
};

}  // namespace symplant::exec
