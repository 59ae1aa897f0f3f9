// True times for random plants.
#include "property/recordings/timed_plant.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "property/random_plant.hpp"

namespace symplant::property {
namespace {

using description::Duration;
using tables::kMillisecond;
using tables::kSecond;
using tables::Time;

Time random_between(Dice& dice, Time least, Time most) {
  return least + static_cast<Time>(dice.below(static_cast<std::size_t>((most - least) / kMillisecond))) * kMillisecond;
}

/// Gives one unit its true times, and each move of 0 s to the next state as often 0 s as not.
class UnitTimes {
 public:
  UnitTimes(Dice& dice, const TimedOptions& options) : dice_(dice), options_(options) {}

  void draw(model::Unit& unit) {
    for (model::Transition& transition : unit.transitions) {
      const bool automatic = transition.on == model::kNone && !transition.spring_return;
      if (!(automatic && transition.takes.is_zero() && dice_.percent(50))) transition.takes = time();
      if (transition.after.is_zero()) continue;
      // Automatic transitions of one moment are drawn by their weights: they stay together.
      const auto group = std::make_tuple(transition.from, transition.after.a, transition.after.b);
      const auto found = automatic ? delays_.find(group) : delays_.end();
      transition.after = found != delays_.end() ? found->second : time();
      if (automatic) delays_[group] = transition.after;
    }
    unit.travel = exact(random_between(dice_, 300 * kMillisecond, 6 * kSecond));
  }

 private:
  Duration time() {
    Duration duration = random_true_time(dice_, options_);
    if (duration.kind == Duration::Kind::fixed) duration.a = exact(duration.a);
    return duration;
  }
  Time exact(Time time) { return options_.exact_times ? time + 1009 * ++number_ : time; }

  Dice& dice_;
  const TimedOptions& options_;
  Time number_ = 0;
  std::map<std::tuple<std::uint32_t, Time, Time>, Duration> delays_;
};

void make_nominal(model::Unit& unit) {
  const auto nominal = [](Duration& duration) { duration = Duration::fixed(duration.is_zero() ? 0 : kSecond); };
  for (model::Transition& transition : unit.transitions) {
    nominal(transition.takes);
    nominal(transition.after);
  }
  unit.travel = kSecond;
}

bool has_moves(const model::PlantModel& plant) {
  return std::any_of(plant.units.begin(), plant.units.end(), [](const model::Unit& unit) {
    return !unit.operations.empty() && !unit.events.empty() && !unit.transitions.empty();
  });
}

}  // namespace

Duration random_true_time(Dice& dice, const TimedOptions& options) {
  if (!options.random_times || dice.percent(50)) {
    return Duration::fixed(random_between(dice, 300 * kMillisecond, 6 * kSecond));
  }
  const Time mean = random_between(dice, 2 * kSecond, 8 * kSecond);
  return {Duration::Kind::uniform, mean - mean / 10, mean + mean / 10};
}

Time longest_move(const model::Unit& unit) {
  const auto most = [](const Duration& duration) {
    return duration.kind == Duration::Kind::uniform ? duration.b : duration.a;
  };
  Time longest = unit.travel;
  for (const model::Transition& transition : unit.transitions) {
    longest = std::max(longest, most(transition.after) + most(transition.takes));
  }
  return longest;
}

TimedPlant timed_plant(std::uint64_t seed, const TimedOptions& options) {
  Dice dice(seed * 2 + 0x71'7E50'0000'0001);
  const DrawOptions draw{.behaviours = false,
                         .most_units = options.most_units,
                         .naming_rules = true,
                         .material = false,
                         .malfunctions = false,
                         .values = false};
  TimedPlant plant;
  for (;; ++plant.refused) {
    plant.described = random_plant(seed + 1'000'000'007 * static_cast<std::uint64_t>(plant.refused), draw).model;
    if (has_moves(plant.described)) break;
  }
  plant.real = plant.described;
  for (model::Unit& unit : plant.real.units) UnitTimes(dice, options).draw(unit);
  plant.described = plant.real;
  for (model::Unit& unit : plant.described.units) make_nominal(unit);
  return plant;
}

}  // namespace symplant::property
