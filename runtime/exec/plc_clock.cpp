// Plant time from a counter of the PLC.
#include "symplant/exec/plc_clock.hpp"

#include <algorithm>
#include <cstdlib>

namespace symplant::exec {

namespace {

/// Keeps the square of a number of cycles within 64 bits.
constexpr std::int64_t kMostPlanned = std::int64_t{1} << 31;

}  // namespace

PlcClock::PlcClock(const PlcClockOptions& options, tables::Time begin) noexcept
    : mask_(~std::uint64_t{0} >> (64 - options.bits)),
      unit_(options.unit),
      largest_step_(std::min(static_cast<std::uint64_t>(options.limit / options.unit), mask_ / 2)),
      now_(begin),
      begin_(begin) {}

bool PlcClock::arrive(std::uint64_t value) noexcept {
  const std::uint64_t difference = (value - value_) & mask_;
  if (has_value_ && difference == 0) return false;
  ++reading_.values;
  value_ = value;
  if (!has_value_) {
    hold();
    has_value_ = true;
    return false;
  }
  if (difference > largest_step_) {
    restart();
    has_value_ = true;
    return true;
  }
  const tables::Time elapsed = static_cast<tables::Time>(difference) * unit_;
  plc_ += elapsed;
  note_phase_error();
  begin_ = now_;
  ahead_ = std::max(plc_ + elapsed - now_, tables::Time{0});
  planned_ = std::clamp(passed_, std::int64_t{1}, has_target_ ? std::min(2 * planned_, kMostPlanned) : kMostPlanned);
  passed_ = 0;
  has_target_ = true;
  return false;
}

tables::Time PlcClock::step(std::int64_t cycles) noexcept {
  if (has_target_ && now_ == begin_ + ahead_) reading_.waits += static_cast<std::uint64_t>(cycles);
  passed_ += cycles;
  const std::int64_t done = std::min(passed_, planned_);
  now_ = begin_ + ahead_ / planned_ * done + ahead_ % planned_ * done / planned_;
  return now_;
}

bool PlcClock::restart() noexcept {
  hold();
  if (reading_.values == 0) return false;
  ++reading_.restarts;
  return true;
}

void PlcClock::hold() noexcept {
  has_value_ = false;
  has_target_ = false;
  plc_ = now_;
  begin_ = now_;
  ahead_ = 0;
  planned_ = 1;
  passed_ = 0;
}

void PlcClock::note_phase_error() noexcept {
  reading_.phase_error = now_ - plc_;
  reading_.largest_phase_error = std::max(reading_.largest_phase_error, std::abs(reading_.phase_error));
}

}  // namespace symplant::exec
