// Runs the real-time cycle: links and plant, once per cycle, at absolute deadlines.
#include "symplant/exec/cycle.hpp"

#include <algorithm>

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec {

namespace {

/// Limits the delay of a stop: a signal to another thread does not end the sleep of this thread.
constexpr tables::Time kLongestSleep = 100 * tables::kMillisecond;
constexpr std::size_t kReportedLinks = 64;
/// In cycles: a longer delay of this process counts only as this much silence of a PLC, as no link could read then.
constexpr tables::Time kStandstill = 2;
constexpr tables::Time kStopped = tables::kNever;

class Run {
 public:
  Run(plant::Plant& plant, std::span<Exchange* const> links, const CycleOptions& options,
      const CycleParts& parts) noexcept
      : plant_(plant),
        links_(links),
        options_(options),
        clock_(parts.clock),
        meter_(parts.meter),
        stop_(parts.stop),
        observer_(parts.observer),
        stepper_(parts.stepper),
        cycle_(std::max(options.cycle, tables::Time{1})),
        spin_(std::clamp(options.spin, tables::Time{0}, cycle_)),
        most_(std::max(options.max_catch_up, std::int64_t{0})),
        time_(plant.now()) {}

  void all() noexcept {
    const Guard guard;
    advance_to(time_);
    write_events(status());
    offset_ = clock_.now() - time_;
    while (time_ < options_.until && !over()) {
      const tables::Time next = options_.until - time_ > cycle_ ? time_ + cycle_ : options_.until;
      const tables::Time woken = wait_until(next + offset_);
      if (woken == kStopped) return;
      one(next, woken);
    }
  }

 private:
  /// The time at which it returns, at or after `deadline`; kStopped if a stop came first.
  tables::Time wait_until(tables::Time deadline) noexcept {
    for (;;) {
      meter_.beats.add(1);
      if (stop_.load(std::memory_order_relaxed)) return kStopped;
      const tables::Time now = clock_.now();
      if (now >= deadline) return now;
      if (deadline - now > spin_) clock_.sleep_until(std::min(deadline - spin_, now + kLongestSleep));
    }
  }

  void one(tables::Time next, tables::Time woken) noexcept {
    const tables::Time lateness = woken - (next + offset_);
    meter_.lateness.add(lateness);
    if (last_start_ != tables::kNever) meter_.jitter.add(std::abs(woken - last_start_ - (next - time_)));
    link_time_ += last_start_ == tables::kNever ? cycle_ : std::min(woken - last_start_, kStandstill * cycle_);
    last_start_ = woken;
    const std::int64_t excess = lateness / cycle_ - most_;
    if (excess > 0) {
      offset_ += excess * cycle_;
      meter_.slipped.add(static_cast<std::uint64_t>(excess * cycle_));
    }

    const tables::Time deadline = next + offset_;
    for (Exchange* link : links_) link->read_operations(plant_, link_time_);
    const CycleStatus reported = status();
    meter_.note_standstill(reported.frozen);
    if (reported.frozen) {
      offset_ += next - time_;
      meter_.frozen.add(static_cast<std::uint64_t>(next - time_));
    } else {
      advance_to(next);
      time_ = next;
    }
    write_events(reported);
    meter_.cycles.add(1);
    const tables::Time end = clock_.now();
    meter_.work.add(end - woken);
    if (end >= deadline + cycle_) meter_.overruns.add(1);
  }

  void advance_to(tables::Time to) noexcept {
    stepper_ != nullptr ? stepper_->advance_to(to) : plant_.advance_to(to, observer_);
  }
  bool over() const noexcept { return stepper_ != nullptr && options_.until == tables::kNever && stepper_->over(); }

  void write_events(const CycleStatus& reported) noexcept {
    for (Exchange* link : links_) link->write_events(plant_, reported);
    plant_.forget_changed_events();
  }

  /// The status for the links, from their states after reading.
  CycleStatus status() noexcept {
    CycleStatus status{.cycles = meter_.cycles.value(), .overruns = meter_.overruns.value()};
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const LinkState state = links_[i]->state();
      meter_.note(i, state);
      if (state == LinkState::live && i < kReportedLinks) status.live |= std::uint64_t{1} << i;
      status.frozen = status.frozen || links_[i]->freezes_plant();
    }
    return status;
  }

  plant::Plant& plant_;
  std::span<Exchange* const> links_;
  const CycleOptions& options_;
  Clock& clock_;
  CycleMeter& meter_;
  const std::atomic<bool>& stop_;
  engine::Observer* observer_;
  Stepper* stepper_;
  tables::Time cycle_;
  tables::Time spin_;
  std::int64_t most_;
  tables::Time time_;                         ///< plant time of the last cycle
  tables::Time offset_ = 0;                   ///< real time minus plant time; grows when plant time slips
  tables::Time link_time_ = 0;                ///< the time by which links measure the silence of their PLC
  tables::Time last_start_ = tables::kNever;  ///< start of the last cycle
};

}  // namespace

void run_cycles(plant::Plant& plant, std::span<Exchange* const> links, const CycleOptions& options,
                const CycleParts& parts) noexcept {
  Run(plant, links, options, parts).all();
  for (Exchange* link : links) link->leave();
}

}  // namespace symplant::exec
