// The real-time cycle: links and plant, once a cycle, on absolute deadlines.
#include "symplant/exec/cycle.hpp"

#include <algorithm>

namespace symplant::exec {

namespace {

/// How long a stop may go unseen: a signal that another thread gets does not end this one's sleep.
constexpr core::Time kLongestSleep = 100 * core::kMillisecond;
constexpr std::size_t kToldLinks = 64;

/// False where `stop` came first.
bool wait_until(core::Time deadline, Clock& clock, const std::atomic<bool>& stop) noexcept {
  for (;;) {
    if (stop.load(std::memory_order_relaxed)) return false;
    const core::Time now = clock.now();
    if (now >= deadline) return true;
    clock.sleep_until(std::min(deadline, now + kLongestSleep));
  }
}

void write_events(core::Plant& plant, std::span<Exchange* const> links, const CycleStatus& status) noexcept {
  for (Exchange* link : links) link->write_events(plant, status);
  plant.forget_changed_events();
}

/// What the links are told of themselves and of each other.
CycleStatus status_of(std::span<Exchange* const> links, const CycleStatistics& statistics) noexcept {
  CycleStatus status{.cycles = statistics.cycles, .overruns = statistics.overruns};
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LinkState state = links[i]->state();
    if (state == LinkState::live && i < kToldLinks) status.live |= std::uint64_t{1} << i;
    status.lost = status.lost || state == LinkState::lost;
    status.frozen = status.frozen || links[i]->freezes_plant();
  }
  return status;
}

}  // namespace

CycleStatistics run_cycles(core::Plant& plant, std::span<Exchange* const> links, const CycleOptions& options,
                           Clock& clock, core::Observer* observer, const std::atomic<bool>& stop,
                           Stepper* stepper) noexcept {
  CycleStatistics statistics;
  const core::Time cycle = std::max(options.cycle, core::Time{1});
  const std::int64_t most = std::max(options.max_catch_up, std::int64_t{0});

  const auto advance_to = [&](core::Time to) {
    stepper != nullptr ? stepper->advance_to(to) : plant.advance_to(to, observer);
  };
  const auto over = [&] { return stepper != nullptr && options.until == core::kNever && stepper->over(); };
  core::Time time = plant.now();
  advance_to(time);
  write_events(plant, links, status_of(links, statistics));

  // Real time minus plant time; grows when plant time slips.
  core::Time offset = clock.now() - time;
  while (time < options.until && !over()) {
    const core::Time next = options.until - time > cycle ? time + cycle : options.until;
    if (!wait_until(next + offset, clock, stop)) break;

    const core::Time lateness = clock.now() - (next + offset);
    statistics.max_lateness = std::max(statistics.max_lateness, lateness);
    const std::int64_t excess = lateness / cycle - most;
    if (excess > 0) {
      offset += excess * cycle;
      statistics.slipped += excess * cycle;
    }

    const core::Time deadline = next + offset;
    for (Exchange* link : links) link->read_operations(plant, deadline + lateness);
    const CycleStatus status = status_of(links, statistics);
    if (status.frozen) {
      offset += next - time;
      statistics.frozen += next - time;
    } else {
      advance_to(next);
      time = next;
    }
    write_events(plant, links, status);
    ++statistics.cycles;
    if (clock.now() >= deadline + cycle) ++statistics.overruns;
  }
  for (Exchange* link : links) link->leave();
  return statistics;
}

}  // namespace symplant::exec
