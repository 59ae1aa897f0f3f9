// Shortest sequences of transitions, searched from the goals backward.
#include "symplant/why/next_states.hpp"

#include <vector>

namespace symplant::why {

States next_states(const tables::TypeRow& type, std::uint8_t here, const States& goals) {
  std::vector<States> before(type.states);  // a state -> those from which a transition leads to it
  for (const tables::Transition& transition : type.transitions) before[transition.to].set(transition.from);
  if (type.actuation == tables::Actuation::spring) before[type.rest].set();  // without a command
  States reached = goals;
  States last = goals;
  while (last.any()) {
    States next;
    for (std::uint8_t state = 0; state < type.states; ++state) {
      if (last[state]) next |= before[state];
    }
    if (next[here]) {
      States steps;
      for (std::uint8_t state = 0; state < type.states; ++state) {
        steps.set(state, last[state] && state != here && before[state][here]);
      }
      return steps;
    }
    last = next & ~reached;
    reached |= next;
  }
  return {};
}

}  // namespace symplant::why
