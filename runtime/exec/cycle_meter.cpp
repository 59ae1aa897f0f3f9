// Measurements of the real-time cycle.
#include "symplant/exec/cycle_meter.hpp"

namespace symplant::exec {

CycleStatistics CycleMeter::statistics() const noexcept {
  CycleStatistics all;
  all.cycles = cycles.value();
  all.overruns = overruns.value();
  all.slipped = static_cast<tables::Time>(slipped.value());
  all.frozen = static_cast<tables::Time>(frozen.value());
  all.lateness = lateness.durations();
  all.work = work.durations();
  all.jitter = jitter.durations();
  return all;
}

void CycleMeter::note(std::size_t link, LinkState state) noexcept {
  if (link >= kMostLinks) return;
  const std::uint64_t before = states_.value();
  const std::uint64_t after = (before & ~(std::uint64_t{3} << (2 * link))) | static_cast<std::uint64_t>(state)
                                                                                 << (2 * link);
  if (after != before) states_.set(after);
}

void CycleMeter::note_standstill(bool is_stopped) noexcept {
  if (is_stopped != this->is_stopped()) is_stopped_.set(is_stopped ? 1 : 0);
}

LinkState CycleMeter::state(std::size_t link) const noexcept {
  return static_cast<LinkState>(states_.value() >> (2 * link) & 3);
}

}  // namespace symplant::exec
