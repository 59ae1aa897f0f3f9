// Symbols that follow a condition.
#include <algorithm>

#include "support/reference/round.hpp"

namespace symplant::reference {
namespace {

bool reads_a_follower(const Rules& rules, const condition::Tree& tree) {
  if (tree.kind == condition::Tree::Kind::atom) {
    return tree.atom.kind == condition::Atom::Kind::bit && rules.follows_condition(tree.atom.of);
  }
  return std::any_of(tree.children.begin(), tree.children.end(),
                     [&](const condition::Tree& child) { return reads_a_follower(rules, child); });
}

}  // namespace

bool follow_conditions(Round& round, int number) {
  bool any = false;
  for (std::size_t i = 0; i < round.rules.follows.size(); ++i) {
    const FollowRules& follow = round.rules.follows[i];
    if (round.old.frozen_follows[i]) continue;
    bool on = holds(*follow.condition, round.old);
    if (follow.off != nullptr) {
      const bool before = round.rules.turned(follow.symbol, round.old.symbols[follow.symbol].value) != 0;
      const bool off = holds(*follow.off, round.old);
      if (on && off) ++round.counters[Counted::hysteresis_both];
      if (before && !on && !off) ++round.counters[Counted::hysteresis_stayed];
      on = !off && (on || before);
    }
    const std::uint64_t bit = round.rules.turned(follow.symbol, on ? 1 : 0);
    if (round.old.symbols[follow.symbol].value == bit) continue;
    const std::vector<std::uint32_t> together = round.rules.together(follow.symbol);
    for (const std::uint32_t each : together) round.next.symbols[each].value = bit;
    round.notes.steps[round.rules.units.size() + i].push_back(number);
    any = true;
    ++round.counters[Counted::follow_switched];
    if (reads_a_follower(round.rules, *follow.condition)) ++round.counters[Counted::follow_chain];
    if (together.size() > 1) ++round.counters[Counted::follow_on_a_shared_address];
  }
  return any;
}

}  // namespace symplant::reference
