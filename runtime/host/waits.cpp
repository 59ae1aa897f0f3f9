// Reports during a run what its plant waits for.
#include "symplant/host/waits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "symplant/host/words.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using exec::LinkState;

constexpr tables::Time kPlcIsDue = 5 * tables::kSecond;
constexpr tables::Time kCountIsDue = 3 * tables::kSecond;

/// Links beyond those that a meter keeps count as live.
LinkState state_of(std::size_t link, const exec::CycleMeter& meter) {
  return link < exec::CycleMeter::kMostLinks ? meter.state(link) : LinkState::live;
}

}  // namespace

Waits::Waits(std::vector<WaitedLink> links, std::string clock)
    : links_(std::move(links)), clock_(std::move(clock)), missed_(links_.size()) {}

std::vector<std::string> Waits::look(tables::Time now, const exec::CycleMeter& meter) {
  std::vector<std::string> lines;
  look_for_plcs(now, meter, lines);
  look_at_freeze(now, meter, lines);
  look_at_clock(now, meter, lines);
  return lines;
}

void Waits::look_for_plcs(tables::Time now, const exec::CycleMeter& meter, std::vector<std::string>& lines) {
  if (now < kPlcIsDue) return;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (missed_[i] || links_[i].absence.empty() || state_of(i, meter) != LinkState::waiting) continue;
    missed_[i] = true;
    lines.push_back(
        fmt::format("warning: no PLC for {}: {}, {}\n", trace::seconds(kPlcIsDue), links_[i].name, links_[i].absence));
  }
}

void Waits::look_at_freeze(tables::Time now, const exec::CycleMeter& meter, std::vector<std::string>& lines) {
  std::size_t by = 0;
  while (by < links_.size() && !(links_[by].freezes && state_of(by, meter) != LinkState::live)) ++by;
  const bool frozen = by < links_.size() && meter.is_stopped();
  if (frozen == frozen_) return;
  frozen_ = frozen;
  if (frozen) {
    frozen_at_ = now;
    shows_freeze_ = freezes_.admits(LineLimit::Clock::time_point(std::chrono::nanoseconds(now)));
  }
  if (!shows_freeze_) return;
  if (frozen) {
    lines.push_back(fmt::format("warning: the plant is frozen, since {} is {}, and its `plant-on-loss` is `freeze`\n",
                                links_[by].name, state_name(state_of(by, meter))));
  } else {
    lines.push_back(
        fmt::format("note: the plant goes on, after {:.1f} s\n", static_cast<double>(now - frozen_at_) / 1e9));
  }
}

void Waits::look_at_clock(tables::Time now, const exec::CycleMeter& meter, std::vector<std::string>& lines) {
  const auto clock = meter.plc_clock();
  if (!clock || clock_.empty()) return;
  if (std::exchange(values_, clock->values) != clock->values || !clock_is_live(meter)) {
    counted_at_ = now;
    stopped_ = false;
  }
  if (stopped_ || now - counted_at_ < kCountIsDue) return;
  stopped_ = true;
  lines.push_back(
      fmt::format("warning: the PLC's clock `{}` has not counted for {}, so plant time waits for it; check whether the "
                  "PLC's program runs and counts it up\n",
                  shown(clock_), trace::seconds(kCountIsDue)));
}

bool Waits::clock_is_live(const exec::CycleMeter& meter) const {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (links_[i].is_clock) return state_of(i, meter) == LinkState::live;
  }
  return true;
}

}  // namespace symplant::host
