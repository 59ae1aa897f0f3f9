// One unit's I/O model: states, then what is inferred, then transitions in their order.
#include "model/derive_unit.hpp"

#include <algorithm>
#include <unordered_map>

#include "base/ascii.hpp"
#include "model/sequence.hpp"

namespace symplant::model {
namespace {

struct Draft {
  std::string_view task;
  std::string_view sequence;
  std::uint32_t first_symbol;
  std::uint32_t operation = kNone;
  std::uint32_t event = kNone;
};

/// Inference 1: the only state gets a counterpart without an event, ordered first.
void add_rest_state(Unit& unit) {
  State rest;
  rest.name = "NOT_" + unit.states.front().name;
  unit.states.insert(unit.states.begin(), std::move(rest));
  unit.rest = 0;
  unit.rest_added = true;
  if (!unit.operations.empty()) unit.actuation = core::Actuation::spring;
}

/// Inference 2: of two states one has an operation and the other just a sensor.
void infer_single_solenoid(Unit& unit) {
  for (std::uint32_t x = 0; x < 2; ++x) {
    const std::uint32_t y = 1 - x;
    const State& commanded = unit.states[x];
    const State& other = unit.states[y];
    if (commanded.operation == kNone || other.operation != kNone) continue;
    unit.two_words = commanded.event == kNone;  // the other has an event, or it would be no state
    if (commanded.event == kNone || other.numbered) continue;
    unit.actuation = core::Actuation::spring;
    unit.rest = y;
    unit.single_solenoid = true;
  }
}

/// Every operation O_X from every state A other than X: by S of the target, then of the source.
void derive_commanded(Unit& unit) {
  const auto count = static_cast<std::uint32_t>(unit.states.size());
  for (std::uint32_t to = 0; to < count; ++to) {
    const std::uint32_t on = unit.states[to].operation;
    if (on == kNone) continue;
    for (std::uint32_t from = 0; from < count; ++from) {
      if (from != to) unit.transitions.push_back({from, to, on, 0, kDefaultTravel, Origin::derived});
    }
  }
}

/// Inference 3: a numbered state with an event and no operation is reached by itself from its predecessor.
void infer_sequence(Unit& unit) {
  if (unit.actuation != core::Actuation::latched) return;
  const auto numbered_with_operation = [](const State& s) { return s.numbered && s.operation != kNone; };
  if (std::none_of(unit.states.begin(), unit.states.end(), numbered_with_operation)) return;

  // Numbered states stand first in S, by number: groups of one number are runs.
  std::vector<std::string_view> numbers;
  for (const State& state : unit.states) {
    if (state.numbered) numbers.push_back(sequence_number(state.name));
  }
  const auto count = static_cast<std::uint32_t>(numbers.size());
  const auto group_begin = [&](std::uint32_t i) {
    while (i > 0 && numbers[i - 1] == numbers[i]) --i;
    return i;
  };
  for (std::uint32_t to = 0; to < count; ++to) {
    if (unit.states[to].event == kNone || unit.states[to].operation != kNone) continue;
    const std::uint32_t begin = group_begin(to);
    const std::uint32_t last = begin > 0 ? begin - 1 : count - 1;  // from the lowest back to the highest
    const std::uint32_t first = group_begin(last);
    if (first != last) {
      unit.ambiguous_sequence.push_back(to);
    } else if (last != to) {
      unit.transitions.push_back({last, to, kNone, kDefaultDwell, 0, Origin::inferred});
    }
  }
}

void choose_initial(Unit& unit, const std::vector<Symbol>& symbols) {
  std::uint32_t candidate = kNone;
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const std::uint32_t event = unit.states[s].event;
    if (event == kNone || symbols[unit.events[event]].initial == 0) continue;
    candidate = s;
    ++unit.initial_candidates;
  }
  if (unit.initial_candidates == 1) {
    unit.initial = candidate;
    unit.initial_from = InitialFrom::initial_column;
  } else if (unit.rest != kNone) {
    unit.initial = unit.rest;
    unit.initial_from = InitialFrom::rest_state;
  } else {
    unit.initial = 0;
    const bool decided =
        unit.states[0].numbered &&
        (unit.states.size() == 1 || sequence_number(unit.states[0].name) != sequence_number(unit.states[1].name));
    unit.initial_from = decided ? InitialFrom::sequence : InitialFrom::row_order;
  }
}

}  // namespace

std::vector<State> states_of(const Unit& unit, const std::vector<Symbol>& symbols) {
  std::vector<Draft> drafts;
  std::unordered_map<std::string_view, std::size_t, base::HashIgnoringCase, base::EqualIgnoringCase> by_task;
  const auto add = [&](std::uint32_t symbol) -> Draft& {
    const std::string_view task = symbols[symbol].reading.task;
    const auto [found, added] = by_task.try_emplace(task, drafts.size());
    if (added) drafts.push_back({task, sequence_number(task), symbol});
    return drafts[found->second];
  };
  for (std::uint32_t i = 0; i < unit.operations.size(); ++i) add(unit.operations[i]).operation = i;
  for (std::uint32_t i = 0; i < unit.events.size(); ++i) {
    Draft& draft = add(unit.events[i]);
    draft.event = i;
    if (unit.events[i] < draft.first_symbol) {  // the first row names the state
      draft.first_symbol = unit.events[i];
      draft.task = symbols[unit.events[i]].reading.task;
    }
  }
  std::sort(drafts.begin(), drafts.end(), [](const Draft& a, const Draft& b) {
    const int order = compare_sequence(a.sequence, b.sequence);
    return order != 0 ? order < 0 : a.first_symbol < b.first_symbol;
  });
  std::vector<State> states;
  states.reserve(drafts.size() + 1);
  for (const Draft& draft : drafts) {
    states.push_back({std::string(draft.task), draft.operation, draft.event, !draft.sequence.empty()});
  }
  return states;
}

void derive_unit(Unit& unit, const std::vector<Symbol>& symbols) {
  unit.states = states_of(unit, symbols);
  if (unit.states.size() == 1) {
    add_rest_state(unit);
  } else if (unit.states.size() == 2) {
    infer_single_solenoid(unit);
  }
  derive_commanded(unit);
  infer_sequence(unit);
  // Where the other word is reached by itself, it is no slip (O_RUN1, I_DONE2).
  for (std::uint32_t s = 0; unit.two_words && s < 2; ++s) {
    if (unit.states[s].operation == kNone && unit.reaches(s)) unit.two_words = false;
  }
  choose_initial(unit, symbols);
}

}  // namespace symplant::model
