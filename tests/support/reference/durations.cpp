// How long a transition waits and travels: fixed, drawn, or asked of a behavior (docs/model.md, "One instant").
#include <algorithm>
#include <cmath>

#include "support/reference/malfunctions.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::reference {
namespace {

__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;

/// The generator of Steele, Lea and Flood.
struct SplitMix64 {
  std::uint64_t state;

  std::uint64_t draw() {
    state += 0x9E37'79B9'7F4A'7C15;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EB;
    return z ^ (z >> 31);
  }
};

SplitMix64 started(std::uint64_t seed, const std::string& unit, std::uint64_t n, std::uint64_t k) {
  tables::Fnv1a64 name;
  name.text(upper(unit));
  return {seed ^ name.value() ^ (n << 32) ^ k};
}

Time uniform(SplitMix64 random, Time least, Time most) {
  const UnsignedWide width = static_cast<UnsignedWide>(most - least) + 1;
  return least + static_cast<Time>(static_cast<UnsignedWide>(random.draw()) * width >> 64);
}

constexpr std::int64_t kOne = std::int64_t{1} << 32;

/// The sum of twelve draws, minus its mean: in 2^-32.
std::int64_t sum_of_twelve(SplitMix64 random) {
  std::int64_t sum = -6 * kOne;
  for (int i = 0; i < 12; ++i) sum += static_cast<std::int64_t>(random.draw() >> 32);
  return sum;
}

Time normal(SplitMix64 random, Time mean, Time sigma) {
  const Wide one = kOne;
  const Wide product = static_cast<Wide>(sigma) * sum_of_twelve(random);
  Wide off = product / one;
  if (product % one < 0) --off;  // floor
  // A time that exceeds the range of Time never comes.
  return static_cast<Time>(std::clamp<Wide>(mean + off, 0, tables::kNever));
}

/// A number of seconds, at most 1e9.
Time time_of(double seconds) {
  if (std::isnan(seconds) || seconds < 0) return 0;
  return static_cast<Time>(std::floor(std::min(seconds, 1e9) * 1e9));
}

/// Without user code: fixed, computed from the snapshot, or drawn.
Time duration_of(Round& round, std::uint32_t unit, std::uint16_t transition, const description::Duration& duration,
                 const Formula& formula) {
  if (duration.kind == description::Duration::Kind::fixed) return duration.a;
  if (duration.kind == description::Duration::Kind::seconds) {
    ++round.counters[Counted::time_computed];
    return time_of(evaluate(formula, {round.rules, round.old}));
  }
  const std::uint32_t k = round.next.units[unit].transitions[transition].draws++;
  ++round
        .counters[duration.kind == description::Duration::Kind::uniform ? Counted::draw_uniform : Counted::draw_normal];
  return draw_duration(round.next.seed, round.of(unit).path, transition, k, duration);
}

Time takes_without_malfunctions(Round& round, std::uint32_t unit, std::uint16_t transition, std::uint8_t from,
                                std::uint8_t to) {
  const UnitRules& rules = round.of(unit);
  if (rules.behaviour != nullptr && rules.behaviour->takes != nullptr) {
    View view(round, unit);
    return std::max<Time>(0, rules.behaviour->takes(view, transition));
  }
  const std::uint16_t source = transition != kNoTransition ? transition : first_not_automatic(rules, from, to);
  if (source == kNoTransition) return rules.travel;
  if (rules.transitions[source].takes.kind != description::Duration::Kind::fixed) ++round.counters[Counted::draw_takes];
  return duration_of(round, unit, source, rules.transitions[source].takes, rules.transitions[source].takes_formula);
}

}  // namespace

Time draw_duration(std::uint64_t seed, const std::string& unit, std::uint64_t n, std::uint64_t k,
                   const description::Duration& duration) {
  const SplitMix64 random = started(seed, unit, n, k);
  if (duration.kind == description::Duration::Kind::uniform) return uniform(random, duration.a, duration.b);
  return normal(random, duration.a, duration.b);
}

Time later(Time now, Time left) { return left > tables::kNever - now ? tables::kNever : now + left; }

std::uint64_t first_output(std::uint64_t seed, const std::string& unit, std::uint64_t n, std::uint64_t k) {
  return started(seed, unit, n, k).draw();
}

double draw_gauss(std::uint64_t seed, const std::string& name, std::uint64_t k) {
  return static_cast<double>(sum_of_twelve(started(seed, name, 0, k))) / static_cast<double>(kOne);
}

std::uint64_t draw_weight(Round& round, std::uint32_t unit, std::uint16_t transition, std::uint64_t sum) {
  const std::uint32_t k = round.next.units[unit].transitions[transition].draws++;
  const std::uint64_t drawn = first_output(round.next.seed, round.of(unit).path, transition, k);
  return static_cast<std::uint64_t>(static_cast<UnsignedWide>(drawn) * sum >> 64);
}

std::uint16_t first_not_automatic(const UnitRules& unit, std::uint8_t from, std::uint8_t to) {
  for (std::uint16_t i = 0; i < unit.transitions.size(); ++i) {
    if (unit.transitions[i].from == from && unit.transitions[i].to == to && !unit.transitions[i].automatic) return i;
  }
  return kNoTransition;
}

bool remembers(const UnitRules& unit, const Transition& transition) {
  return (unit.behaviour != nullptr && unit.behaviour->after != nullptr) || !transition.after.is_zero();
}

Time takes_of(Round& round, std::uint32_t unit, std::uint16_t transition, std::uint8_t from, std::uint8_t to) {
  const Time time = takes_without_malfunctions(round, unit, transition, from, to);
  return slowed(round.rules, round.next, unit, time, round.counters);
}

Time after_of(Round& round, std::uint32_t unit, std::uint16_t transition) {
  const UnitRules& rules = round.of(unit);
  if (rules.behaviour != nullptr && rules.behaviour->after != nullptr) {
    View view(round, unit);
    return std::max<Time>(0, rules.behaviour->after(view, transition));
  }
  if (rules.transitions[transition].after.kind != description::Duration::Kind::fixed)
    ++round.counters[Counted::draw_after];
  return duration_of(round, unit, transition, rules.transitions[transition].after,
                     rules.transitions[transition].after_formula);
}

}  // namespace symplant::reference
