// A PLC with a clock, and a plant that follows it, both on simulated time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <utility>

#include "symplant/exec/plc_clock.hpp"

namespace symplant::test {

using tables::kMicrosecond;
using tables::kMillisecond;
using tables::kSecond;
using tables::Time;

inline constexpr Time kMinute = 60 * kSecond;
inline constexpr Time kHour = 60 * kMinute;

struct SimulatedPlc {
  int bits = 32;
  Time unit = kMillisecond;
  std::uint64_t first = 0;          ///< value of the counter at time 0
  std::int64_t rate_numerator = 1;  ///< of its clock to real time
  std::int64_t rate_denominator = 1;
  Time interval = 100 * kMillisecond;  ///< from value to value
  Time more = 0;                       ///< an interval is up to this much longer
  Time jitter = 0;                     ///< a value comes up to this much later
  bool delayed = false;                ///< by the network: the value was read before the jitter, not after it
  int lost = 0;                        ///< of 100 values
  int repeated = 0;                    ///< of 100 values
  Time stops_every = 0;                ///< the PLC stops for a minute; 0: never
  Time cycle = 10 * kMillisecond;      ///< of the plant
};

/// What a run has shown.
struct Followed {
  Time plc = 0;            ///< time that passed on the PLC, between the first value and the last
  Time plant = 0;          ///< the same of the plant
  Time largest_step = 0;   ///< of the PLC's clock, from value to value
  Time farthest = 0;       ///< the PLC's clock from plant time, over all cycles
  Time largest_cycle = 0;  ///< time that passes on the PLC in one cycle
  int backward = 0;        ///< cycles in which plant time went back
  exec::PlcClockReading reading;

  double rate() const { return static_cast<double>(plant) / static_cast<double>(plc); }
};

/// Follows a simulated PLC for `duration` of real time.
class Simulation {
 public:
  explicit Simulation(const SimulatedPlc& plc)
      : plc_(plc), clock_({plc.bits, plc.unit}, kBegin), next_value_(plc.interval) {}

  Followed run(Time duration) {
    result_.largest_cycle = plc_time(plc_.cycle);
    for (Time now = plc_.cycle; now <= duration; now += plc_.cycle) {
      while (arrival() <= now) value();
      const Time before = clock_.now();
      const Time plant = clock_.step();
      if (plant < before) ++result_.backward;
      if (!has_base_) continue;
      result_.farthest = std::max(result_.farthest, std::abs(plant - kBegin - (plc_time(now) - base_)));
    }
    result_.reading = clock_.reading();
    return result_;
  }

 private:
  static constexpr Time kBegin = 7 * kSecond;

  /// What the PLC's clock shows at a real time: it does not run while the PLC is stopped.
  Time plc_time(Time real) const {
    Time running = real;
    if (plc_.stops_every != 0) {
      const Time period = plc_.stops_every + kMinute;
      running = real / period * plc_.stops_every + std::min(real % period, plc_.stops_every);
    }
    return running / plc_.rate_denominator * plc_.rate_numerator +
           running % plc_.rate_denominator * plc_.rate_numerator / plc_.rate_denominator;
  }
  Time arrival() const { return next_value_ + late_; }

  void value() {
    const Time shown = plc_time(plc_.delayed ? next_value_ : arrival());
    const bool is_lost = draw(100) < plc_.lost;
    const auto counter = plc_.first + static_cast<std::uint64_t>(shown / plc_.unit);
    if (!is_lost) arrive(counter, shown);
    if (draw(100) < plc_.repeated) clock_.arrive(counter);
    next_value_ += plc_.interval + draw(plc_.more);
    late_ = draw(plc_.jitter);
  }

  void arrive(std::uint64_t counter, Time shown) {
    const auto values = clock_.reading().values;
    clock_.arrive(counter);
    if (clock_.reading().values == values) return;
    if (!std::exchange(has_base_, true)) {
      base_ = shown;
      last_ = shown;
    }
    result_.largest_step = std::max(result_.largest_step, shown - std::exchange(last_, shown));
    result_.plc = shown - base_;
    result_.plant = clock_.now() - kBegin;
  }

  Time draw(Time below) { return below == 0 ? 0 : static_cast<Time>(random_() % static_cast<std::uint64_t>(below)); }

  const SimulatedPlc plc_;
  exec::PlcClock clock_;
  std::mt19937_64 random_{2024};
  Time next_value_;
  Time late_ = 0;
  Time base_ = 0;
  Time last_ = 0;
  bool has_base_ = false;
  Followed result_;
};

}  // namespace symplant::test
