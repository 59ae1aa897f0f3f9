// Makes faster and slower plants.
#include "suite/plants.hpp"

#include <algorithm>
#include <map>

namespace symplant::suite {
namespace {

using tables::Time;

class Scaling {
 public:
  Scaling(lower::EngineTables& tables, Speed speed) : tables_(tables), fast_(speed == Speed::fast) {}

  void scale(std::vector<tables::TransitionTimes>& times) {
    for (tables::TransitionTimes& one : times) one.takes = one.takes < 0 ? drawn(one.takes) : scaled(one.takes);
  }

 private:
  Time scaled(Time time) const {
    constexpr Time kMost = tables::kNever / 4;
    if (fast_) return time == 0 ? 0 : std::max<Time>(1, time / 5);
    return time > kMost ? time : 3 * time;
  }

  /// The reference to a random time that is scaled; the one that is there may be that of a delay, too.
  Time drawn(Time reference) {
    const auto [at, is_new] = drawn_.try_emplace(reference, 0);
    if (!is_new) return at->second;
    tables::RandomTime time = tables_.random_times[static_cast<std::size_t>(-1 - reference)];
    time.a = scaled(time.a);
    time.b = scaled(time.b);
    tables_.random_times.push_back(time);
    return at->second = -static_cast<Time>(tables_.random_times.size());
  }

  lower::EngineTables& tables_;
  const bool fast_;
  std::map<Time, Time> drawn_;
};

}  // namespace

lower::EngineTables at_speed(const lower::EngineTables& tables, Speed speed) {
  lower::EngineTables copy = tables.copy();
  if (speed == Speed::normal) return copy;
  Scaling scaling(copy, speed);
  for (lower::Type& type : copy.types) scaling.scale(type.times);
  scaling.scale(copy.times);
  return copy;
}

}  // namespace symplant::suite
