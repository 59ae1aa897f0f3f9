// Plant time from a counter of the PLC: follows its rate and its stops.
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::exec {

struct PlcClockOptions {
  int bits = 16;                              ///< width of the counter: 16, 32 or 64; it wraps there
  tables::Time unit = tables::kMillisecond;   ///< of its lowest bit, > 0
  tables::Time limit = 10 * tables::kSecond;  ///< a longer step of the counter is a restart; at most half its range
};

/// What a PlcClock has measured.
struct PlcClockReading {
  std::uint64_t values = 0;              ///< values that arrived
  tables::Time phase_error = 0;          ///< plant time minus the PLC's time, at the last value
  tables::Time largest_phase_error = 0;  ///< its largest absolute value
  std::uint64_t waits = 0;               ///< cycles in which plant time waited for the next value
  std::uint64_t restarts = 0;

  /// Whether plant time has run by this clock: it needs two values.
  bool has_counted() const noexcept { return values > 1; }
};

/// Vergnano's synchronizer. A value that arrives adds its difference from the last one, d, to the PLC's time. Plant
/// time then goes to its target, the PLC's time plus d, in as many equal steps as there were cycles between the last
/// two values, but at most twice as many as before (docs/decisions/0036), and waits there. It never goes back. The
/// first value, and the first after a restart, only sets the PLC's time to plant time.
///
/// Pure arithmetic, O(1). Rounding does not accumulate: the PLC's time is an exact sum, and a target is reached
/// exactly.
class PlcClock {
 public:
  PlcClock(const PlcClockOptions& options, tables::Time begin) noexcept;

  /// A value of the counter, modulo its width. A repeated value changes nothing. Returns whether it is a restart: the
  /// counter stepped by more than the limit, or back.
  bool arrive(std::uint64_t value) noexcept;
  /// Advances plant time by this many cycles, > 0; returns it.
  tables::Time step(std::int64_t cycles = 1) noexcept;
  /// The PLC has reconnected: plant time goes on from where it is. Returns whether this counts as a restart, which
  /// needs values that arrived before.
  bool restart() noexcept;
  /// Plant time was stopped: it goes on from where it is. This does not count as a restart.
  void hold() noexcept;

  tables::Time now() const noexcept { return now_; }
  const PlcClockReading& reading() const noexcept { return reading_; }

 private:
  void note_phase_error() noexcept;

  std::uint64_t mask_;
  tables::Time unit_;
  std::uint64_t largest_step_;  ///< of the counter, without a restart
  PlcClockReading reading_;
  std::uint64_t value_ = 0;  ///< the last one
  bool has_value_ = false;   ///< the PLC's time is known
  bool has_target_ = false;
  tables::Time plc_ = 0;      ///< the PLC's time at the last value
  tables::Time now_;          ///< plant time
  tables::Time begin_;        ///< plant time at the last value
  tables::Time ahead_ = 0;    ///< from `begin_` to the target
  std::int64_t planned_ = 1;  ///< cycles to the target
  std::int64_t passed_ = 0;   ///< cycles since the last value
};

}  // namespace symplant::exec
