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
  all.plc_clock = plc_clock();
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

void CycleMeter::note(const PlcClockReading& plc_clock) noexcept {
  has_plc_clock_.set(1);
  plc_values_.set(plc_clock.values);
  phase_error_.set(static_cast<std::uint64_t>(plc_clock.phase_error));
  largest_phase_error_.set(static_cast<std::uint64_t>(plc_clock.largest_phase_error));
  waits_.set(plc_clock.waits);
  restarts_.set(plc_clock.restarts);
}

std::optional<PlcClockReading> CycleMeter::plc_clock() const noexcept {
  if (has_plc_clock_.value() == 0) return std::nullopt;
  return PlcClockReading{plc_values_.value(), static_cast<tables::Time>(phase_error_.value()),
                         static_cast<tables::Time>(largest_phase_error_.value()), waits_.value(), restarts_.value()};
}

LinkState CycleMeter::state(std::size_t link) const noexcept {
  return static_cast<LinkState>(states_.value() >> (2 * link) & 3);
}

}  // namespace symplant::exec
