// What the cycles are measured by: counted by the thread of the cycle, read by any.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/exec/exchange.hpp"
#include "symplant/exec/histogram.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// What a run came to, or has come to so far. Times in nanoseconds.
struct CycleStatistics {
  std::uint64_t cycles = 0;
  std::uint64_t overruns = 0;  ///< cycles that were not finished when the next was due
  tables::Time slipped = 0;    ///< plant time lost: the plant's clock is behind the real one by so much
  tables::Time frozen = 0;     ///< plant time that stood still, as a lost link's policy says
  Durations lateness;          ///< from a cycle's deadline to its start
  Durations work;              ///< from a cycle's start to its end: links and plant
  Durations jitter;            ///< by how much the time from one start to the next was off the cycle, either way
};

/// Fixed memory (90 kB) and a fixed cost a cycle.
class CycleMeter {
 public:
  static constexpr std::size_t kMostLinks = 32;  ///< whose states are kept

  Counter beats;  ///< each time the cycle looks at the clock: ten times a second at least, while it goes on
  Counter cycles;
  Counter overruns;
  Counter slipped;  ///< ns
  Counter frozen;   ///< ns
  Histogram lateness;
  Histogram work;
  Histogram jitter;

  CycleStatistics statistics() const noexcept;

  void note(std::size_t link, LinkState state) noexcept;
  /// Whether the plant stood still in the latest cycle, as a lost link's policy says.
  void note_standstill(bool is_stopped) noexcept;
  bool is_stopped() const noexcept { return is_stopped_.value() != 0; }
  /// Of a link below kMostLinks: how it stood in the latest cycle.
  LinkState state(std::size_t link) const noexcept;

 private:
  Counter states_;      ///< two bits a link
  Counter is_stopped_;  ///< 0 or 1
};

}  // namespace symplant::exec
