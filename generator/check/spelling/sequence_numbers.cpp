// Sequence numbers as numbers.
#include "check/spelling/sequence_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "model/sequence.hpp"

namespace symplant::check {

void numbered_states(const model::Unit& unit, std::vector<NumberedState>& states) {
  constexpr std::size_t kMostDigits = 18;
  states.clear();
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const model::State& state = unit.states[s];
    if (!state.numbered) continue;
    std::uint32_t first = model::kNone;
    if (state.operation != model::kNone) first = unit.operations[state.operation];
    if (state.event != model::kNone) first = std::min(first, unit.events[state.event]);
    if (first == model::kNone) continue;
    const std::string_view digits = model::sequence_number(state.name);
    if (digits.size() > kMostDigits) {
      states.clear();
      return;
    }
    std::uint64_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    states.push_back({number, s, first});
  }
  std::sort(states.begin(), states.end(), [](const NumberedState& a, const NumberedState& b) {
    return a.number != b.number ? a.number < b.number : a.symbol < b.symbol;
  });
}

}  // namespace symplant::check
