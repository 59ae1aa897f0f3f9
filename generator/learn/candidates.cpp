// Compares a sample of the changes of each operation with the changes of events after them.
#include "learn/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "learn/follow.hpp"

namespace symplant::learn {
namespace {

constexpr std::size_t kMostSamples = 12;
/// The causes kept for each event and direction.
constexpr std::size_t kMostConstant = 12;
/// Those that change last before the event: one of many other operations may have delays that are constant by chance.
constexpr std::size_t kNearest = 4;
/// Changes of events that are looked at after one change of an operation: in busier recordings the time is shorter.
constexpr std::size_t kMostEffects = 8192;

/// The samples that must have a delay: half of them, as at the others the event may have its value already.
constexpr std::size_t samples_needed(std::size_t samples) { return (samples + 1) / 2; }

/// A change of an event to on.
struct Effect {
  Time time;
  std::uint32_t of;  ///< index of the event
};

std::vector<Effect> effects_of(const std::vector<std::uint32_t>& events, const Timeline& timeline) {
  std::vector<Effect> effects;
  for (std::uint32_t e = 0; e < events.size(); ++e) {
    for (const Time time : timeline.tracks[events[e]].rises) effects.push_back({time, e});
  }
  std::sort(effects.begin(), effects.end(),
            [](const Effect& a, const Effect& b) { return a.time != b.time ? a.time < b.time : a.of < b.of; });
  return effects;
}

/// The delays of one event after the samples of one cause, in one line of the cache.
struct alignas(64) Delays {
  std::uint32_t last = 0;  ///< the number of the sample that has the last one
  std::uint32_t count = 0;
  std::array<std::uint32_t, kMostSamples> times{};  ///< in us
};
constexpr Time kMicrosecond = tables::kSecond / 1'000'000;

class Sampler {
 public:
  Sampler(const std::vector<std::uint32_t>& events, const Timeline& timeline)
      : timeline_(timeline),
        effects_(effects_of(events, timeline)),
        delays_(events.size()),
        constant_(events.size()),
        nearest_(events.size()) {}

  void take(const EdgeOf& cause) {
    const Track& track = timeline_.tracks[cause.symbol];
    const std::vector<Time>& times = cause.on ? track.rises : track.falls;
    if (times.size() < kLeastChanges) return;
    const std::size_t samples = std::min(times.size(), kMostSamples);
    for (std::size_t s = 0; s < samples; ++s) sample(times, s * times.size() / samples);
    for (const std::uint32_t effect : touched_) {
      Delays& delays = delays_[effect];
      if (delays.count >= samples_needed(samples)) offer(effect, cause, delays, samples);
      delays.count = 0;
    }
    touched_.clear();
  }

  std::vector<std::vector<EdgeOf>> best() const {
    std::vector<std::vector<EdgeOf>> all(constant_.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const auto* ranking : {&constant_[i], &nearest_[i]}) {
        for (const Ranked& ranked : *ranking) add_once(ranked.cause, all[i]);
      }
    }
    return all;
  }

 private:
  struct Ranked {
    EdgeOf cause;
    double rank;
  };

  static void add_once(const EdgeOf& cause, std::vector<EdgeOf>& causes) {
    const bool has = std::any_of(causes.begin(), causes.end(), [&](const EdgeOf& other) {
      return other.symbol == cause.symbol && other.on == cause.on;
    });
    if (!has) causes.push_back(cause);
  }

  /// Keeps the delay of each event that changes after one change of an operation, before its next one.
  void sample(const std::vector<Time>& times, std::size_t i) {
    const Time time = times[i];
    Time end = std::min(time + kLongestDelay, timeline_.stretch_of(time).end);
    if (i + 1 < times.size()) end = std::min(end, times[i + 1] - 1);
    auto effect =
        std::lower_bound(effects_.begin(), effects_.end(), time, [](const Effect& a, Time t) { return a.time < t; });
    const auto last = effects_.end() - effect > std::ptrdiff_t{kMostEffects} ? effect + kMostEffects : effects_.end();
    ++sample_;
    for (; effect != last && effect->time <= end; ++effect) {
      Delays& delays = delays_[effect->of];
      if (delays.last == sample_) continue;
      delays.last = sample_;
      if (delays.count == 0) touched_.push_back(effect->of);
      delays.times[delays.count++] = static_cast<std::uint32_t>((effect->time - time) / kMicrosecond);
    }
  }

  /// Ranks by how much the delays differ, and how many changes have none.
  void offer(std::uint32_t effect, const EdgeOf& cause, Delays& delays, std::size_t samples) {
    const std::span<std::uint32_t> times(delays.times.data(), delays.count);
    std::sort(times.begin(), times.end());
    keep({cause, static_cast<double>(times[times.size() / 2])}, kNearest, nearest_[effect]);
    const std::size_t count = std::max(samples_needed(samples), (times.size() * 3 + 3) / 4);
    const std::size_t first = closest<std::uint32_t>(times, count);
    const double missed = static_cast<double>(samples - times.size()) / static_cast<double>(samples);
    std::vector<Ranked>& constant = constant_[effect];
    if (constant.size() == kMostConstant) {
      // A lower limit that costs less: a deviation is at least that of two delays that differ from all others.
      const double width = times[first + count - 1] - times[first];
      if (rank_of(width / std::sqrt(2 * static_cast<double>(count)), missed) >= constant.back().rank) return;
    }
    const double deviation = deviation_of<std::uint32_t>(times.subspan(first, count));
    keep({cause, rank_of(deviation, missed)}, kMostConstant, constant);
  }

  /// `deviation`: in us.
  static double rank_of(double deviation, double missed) {
    constexpr double kLeastDeviation = 1000;
    return (deviation + kLeastDeviation) * (1 + missed);
  }

  static void keep(const Ranked& ranked, std::size_t most, std::vector<Ranked>& best) {
    if (best.size() == most) {
      if (ranked.rank >= best.back().rank) return;
      best.pop_back();
    }
    const auto at = std::upper_bound(best.begin(), best.end(), ranked.rank,
                                     [](double rank, const Ranked& other) { return rank < other.rank; });
    best.insert(at, ranked);
  }

  const Timeline& timeline_;
  const std::vector<Effect> effects_;
  std::vector<Delays> delays_;                 ///< by effect
  std::vector<std::vector<Ranked>> constant_;  ///< by effect: those with the most constant delays first
  std::vector<std::vector<Ranked>> nearest_;   ///< by effect: those with the shortest delays first
  std::vector<std::uint32_t> touched_;         ///< the effects that have delays
  std::uint32_t sample_ = 0;                   ///< the number of the sample
};

}  // namespace

std::vector<std::vector<EdgeOf>> candidates_of(const std::vector<std::uint32_t>& operations,
                                               const std::vector<std::uint32_t>& events, const Timeline& timeline) {
  Sampler sampler(events, timeline);
  for (const std::uint32_t operation : operations) {
    sampler.take({operation, true});
    sampler.take({operation, false});
  }
  return sampler.best();
}

}  // namespace symplant::learn
