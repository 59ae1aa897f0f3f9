// Measurements of the real-time cycle: the cycle's thread writes them, any thread may read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "symplant/exec/exchange.hpp"
#include "symplant/exec/histogram.hpp"
#include "symplant/exec/plc_clock.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// The statistics of a run, so far or at its end. Times in nanoseconds.
struct CycleStatistics {
  std::uint64_t cycles = 0;
  std::uint64_t overruns = 0;  ///< cycles that were not finished when the next was due
  tables::Time slipped = 0;    ///< how much plant time fell behind the clock
  tables::Time frozen = 0;     ///< time during which plant time did not run, by the policy of a lost link
  Durations lateness;          ///< from a cycle's deadline to its start
  Durations work;              ///< from a cycle's start to its end: links and plant
  Durations jitter;            ///< by how much the time between two starts differs from the cycle, absolute
  std::optional<PlcClockReading> plc_clock;  ///< only if plant time follows a PLC's clock
};

/// Fixed memory (90 kB) and a fixed cost per cycle.
class CycleMeter {
 public:
  static constexpr std::size_t kMostLinks = 32;  ///< number of links whose states are kept

  Counter beats;  ///< grows each time the cycle reads the clock: at least ten times a second while it runs
  Counter cycles;
  Counter overruns;
  Counter slipped;  ///< ns
  Counter frozen;   ///< ns
  Histogram lateness;
  Histogram work;
  Histogram jitter;

  CycleStatistics statistics() const noexcept;

  void note(std::size_t link, LinkState state) noexcept;
  /// Whether the plant was frozen in the last cycle, by the policy of a lost link.
  void note_standstill(bool is_stopped) noexcept;
  bool is_stopped() const noexcept { return is_stopped_.value() != 0; }
  void note(const PlcClockReading& plc_clock) noexcept;
  /// Nothing if plant time follows the wall clock.
  std::optional<PlcClockReading> plc_clock() const noexcept;
  /// The state of a link in the last cycle; `link` must be below kMostLinks.
  LinkState state(std::size_t link) const noexcept;

 private:
  Counter states_;         ///< two bits per link
  Counter is_stopped_;     ///< 0 or 1
  Counter has_plc_clock_;  ///< 0 or 1
  Counter plc_values_;
  Counter phase_error_;  ///< two's complement
  Counter largest_phase_error_;
  Counter waits_;
  Counter restarts_;
};

}  // namespace symplant::exec
