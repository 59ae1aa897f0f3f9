// What malfunctions do in the reference.
#include <algorithm>

#include "support/reference/malfunctions.hpp"

namespace symplant::reference {
namespace {

using tables::MalfunctionKind;

constexpr std::uint32_t kThreeTimes = 3000;

__extension__ using Wide = __int128;

Time times(Time time, std::uint32_t thousandths) {
  if (time == tables::kNever) return time;
  const Wide product = static_cast<Wide>(time) * thousandths / 1000;
  return static_cast<Time>(std::min<Wide>(product, tables::kNever));
}

/// What one malfunction makes of a symbol that is `now`.
SymbolOverride overridden(const Rules& rules, const World& world, std::uint32_t number, std::uint32_t symbol,
                          SymbolOverride now) {
  using Kind = SymbolOverride::Kind;
  const MalfunctionRules it = malfunction_of(rules, number);
  const std::vector<std::uint32_t> together = rules.together(symbol);
  const auto is_it = [&](std::uint32_t other) {
    return std::find(together.begin(), together.end(), other) != together.end();
  };
  if (it.kind == MalfunctionKind::force && it.written == nullptr && is_it(it.of)) {
    return {Kind::value, it.on ? std::uint64_t{1} : 0};
  }
  if (it.kind == MalfunctionKind::force && it.written != nullptr) {
    for (const tables::MalfunctionForce& force : it.written->forces) {
      if (is_it(force.symbol)) now = {Kind::value, force.value};
    }
  }
  if (it.kind == MalfunctionKind::flicker && is_it(it.written->subject) &&
      world.malfunctions.written[number].shows_opposite) {
    if (now.kind == Kind::value) return {Kind::value, now.value ^ 1};
    return {now.kind == Kind::none ? Kind::opposite : Kind::none, 0};
  }
  return now;
}

}  // namespace

bool MalfunctionRules::names_unit(std::uint32_t unit) const {
  if (kind != MalfunctionKind::stuck && kind != MalfunctionKind::slower) return false;
  if (written == nullptr) return of == unit;
  return std::any_of(written->units.begin(), written->units.end(),
                     [&](const tables::MalfunctionUnit& named) { return named.unit == unit; });
}

bool is_stuck(const Rules& rules, const World& world, std::uint32_t unit) {
  return std::any_of(world.malfunctions.active.begin(), world.malfunctions.active.end(), [&](const ActiveWorld& one) {
    const MalfunctionRules it = malfunction_of(rules, one.number);
    return it.kind == MalfunctionKind::stuck && it.names_unit(unit);
  });
}

Time slowed(const Rules& rules, const World& world, std::uint32_t unit, Time time, Counters& counters) {
  const auto written = static_cast<std::uint32_t>(rules.model->malfunctions.size());
  std::vector<std::uint32_t> numbers;  // the written ones in their order, then the ordinary ones
  for (std::uint32_t i = 0; i < written; ++i) {
    if (is_active(world, i)) numbers.push_back(i);
  }
  for (const ActiveWorld& one : world.malfunctions.active) {
    if (one.number >= written) numbers.push_back(one.number);
  }
  const Time without = time;
  int slower = 0;
  for (const std::uint32_t number : numbers) {
    const MalfunctionRules it = malfunction_of(rules, number);
    if (it.kind != MalfunctionKind::slower || !it.names_unit(unit)) continue;
    time = times(time, it.written == nullptr ? kThreeTimes : it.written->factor);
    ++slower;
    ++counters[it.written == nullptr ? Counted::slow_by_ordinary : Counted::slow_by_written];
  }
  if (slower > 1) ++counters[Counted::slow_by_several];
  if (without != 0 && time == 0) ++counters[Counted::slower_takes_nothing];
  return time;
}

bool overrides_one_of(const Rules& rules, std::uint32_t number, const std::vector<std::uint32_t>& symbols) {
  const MalfunctionRules it = malfunction_of(rules, number);
  const auto is_one = [&](std::uint32_t symbol) {
    return std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
  };
  if (it.kind == MalfunctionKind::flicker) return is_one(it.written->subject);
  if (it.kind != MalfunctionKind::force) return false;
  if (it.written == nullptr) return is_one(it.of);
  return std::any_of(it.written->forces.begin(), it.written->forces.end(),
                     [&](const tables::MalfunctionForce& force) { return is_one(force.symbol); });
}

void override_symbols(const Rules& rules, World& world) {
  for (std::uint32_t i = 0; i < world.symbols.size(); ++i) {
    SymbolOverride to;
    for (const ActiveWorld& one : world.malfunctions.active) to = overridden(rules, world, one.number, i, to);
    world.symbols[i].broken = to;
  }
}

}  // namespace symplant::reference
