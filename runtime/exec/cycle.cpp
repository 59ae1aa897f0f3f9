// Runs the real-time cycle: links and plant, once per cycle, at absolute deadlines.
#include "symplant/exec/cycle.hpp"

#include <algorithm>
#include <utility>

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec {

namespace {

/// Limits the delay of a stop: a signal to another thread does not end the sleep of this thread.
constexpr tables::Time kLongestSleep = 100 * tables::kMillisecond;
constexpr std::size_t kReportedLinks = 64;
/// In cycles: a longer delay of this process counts only as this much silence of a PLC, as no link could read then.
constexpr tables::Time kStandstill = 2;
/// A shorter standstill is only counted as slipped time.
constexpr tables::Time kReportedStandstill = tables::kSecond;
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
        plc_time_(parts.plc_time),
        standstill_(parts.standstill),
        cycle_(std::max(options.cycle, tables::Time{1})),
        spin_(std::clamp(options.spin, tables::Time{0}, cycle_)),
        most_(plc_time_ != nullptr ? 0 : std::max(options.max_catch_up, std::int64_t{0})),
        time_(plant.now()) {}

  void all() noexcept {
    const Guard guard;
    const CycleStatus first = status();
    first.frozen ? plant_.show(observer_) : begin();
    time_ = plant_.now();
    write_events(first);
    note_plc_clock();
    deadline_ = clock_.now();
    while (time_ < options_.until && !has_waited_enough() && !over() && !failed()) {
      const tables::Time length = plc_time_ != nullptr ? cycle_ : std::min(cycle_, options_.until - time_);
      deadline_ += length;
      const tables::Time woken = wait_until(deadline_);
      if (woken == kStopped) return;
      one(length, woken);
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

  void one(tables::Time length, tables::Time woken) noexcept {
    const tables::Time lateness = woken - deadline_;
    meter_.lateness.add(lateness);
    if (last_start_ != tables::kNever) meter_.jitter.add(std::abs(woken - last_start_ - length));
    link_time_ += last_start_ == tables::kNever ? cycle_ : std::min(woken - last_start_, kStandstill * cycle_);
    last_start_ = woken;
    const std::int64_t excess = std::max(lateness / cycle_ - most_, std::int64_t{0});
    deadline_ += excess * cycle_;
    if (plc_time_ == nullptr) meter_.slipped.add(static_cast<std::uint64_t>(excess * cycle_));

    if (standstill_ != nullptr && excess * cycle_ >= kReportedStandstill) standstill_->stood_still(excess * cycle_);
    for (Exchange* link : links_) link->read_operations(plant_, link_time_);
    const CycleStatus reported = status();
    meter_.note_standstill(reported.frozen);
    waited_ = waits_for_plc() ? waited_ + length : 0;
    if (reported.frozen) {
      meter_.frozen.add(static_cast<std::uint64_t>(length));
      if (plc_time_ != nullptr) plc_time_->hold(plant_);
      if (stepper_ != nullptr) stepper_->hold();
    } else {
      begin();
      advance_to(plc_time_ == nullptr ? time_ + length : std::min(plc_time_->next(plant_, excess + 1), options_.until));
    }
    time_ = plant_.now();
    note_plc_clock();
    write_events(reported);
    meter_.cycles.add(1);
    const tables::Time end = clock_.now();
    meter_.work.add(end - woken);
    if (end >= deadline_ + cycle_) meter_.overruns.add(1);
  }

  /// The first instant; a plant that is frozen from the start has not run it.
  void begin() noexcept {
    if (!std::exchange(begun_, true)) advance_to(time_);
  }

  void advance_to(tables::Time to) noexcept {
    stepper_ != nullptr ? stepper_->advance_to(to) : plant_.advance_to(to, observer_);
  }
  bool waits_for_plc() const noexcept {
    return std::any_of(links_.begin(), links_.end(), [](const Exchange* link) { return link->freezes_plant(); }) ||
           (plc_time_ != nullptr && plc_time_->is_without_plc());
  }
  /// Without an end there is no limit.
  bool has_waited_enough() const noexcept {
    return options_.until != tables::kNever && waited_ >= std::max(options_.until - time_, kPatience);
  }
  bool over() const noexcept {
    return stepper_ != nullptr && (options_.until == tables::kNever || options_.ends_when_over) && stepper_->over();
  }

  bool failed() const noexcept { return stepper_ != nullptr && stepper_->failed(); }

  void write_events(const CycleStatus& reported) noexcept {
    for (Exchange* link : links_) link->write_events(plant_, reported);
    plant_.forget_changed_events();
  }

  void note_plc_clock() noexcept {
    if (plc_time_ != nullptr) meter_.note(plc_time_->reading());
  }

  /// The status for the links, from their states after reading.
  CycleStatus status() noexcept {
    CycleStatus status{.cycles = meter_.cycles.value(),
                       .overruns = meter_.overruns.value(),
                       .frozen = stepper_ != nullptr && stepper_->frozen()};
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
  PlcTime* plc_time_;
  StandstillWatch* standstill_;
  tables::Time cycle_;
  tables::Time spin_;
  std::int64_t most_;
  bool begun_ = false;                        ///< the first instant has run
  tables::Time time_;                         ///< plant time after the last cycle
  tables::Time deadline_ = 0;                 ///< of the last cycle that was due
  tables::Time link_time_ = 0;                ///< the time by which links measure the silence of their PLC
  tables::Time last_start_ = tables::kNever;  ///< start of the last cycle
  tables::Time waited_ = 0;                   ///< for which the plant has waited for a PLC without a break
};

}  // namespace

void run_cycles(plant::Plant& plant, std::span<Exchange* const> links, const CycleOptions& options,
                const CycleParts& parts) noexcept {
  Run(plant, links, options, parts).all();
  for (Exchange* link : links) link->leave();
}

}  // namespace symplant::exec
