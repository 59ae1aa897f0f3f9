// One unit's I/O model: states, then what is inferred, then transitions in their order.
#include "model/derive_unit.hpp"

#include <algorithm>

#include "model/given.hpp"
#include "model/sequence.hpp"
#include "model/states.hpp"

namespace symplant::model {
namespace {

/// The state of a device whose symbols name none.
constexpr std::string_view kOnlyState = "IDLE";

/// The result of inferences 1 and 2.
struct InferredRest {
  std::uint32_t rest = kNone;
  bool spring = false;
};

/// Whether the only state is the one of a device whose symbols name none.
bool is_placeholder(const Unit& unit) {
  const State& only = unit.states.front();
  return only.operation == kNone && only.event == kNone &&
         (unit.described == nullptr || unit.described->states.empty());
}

/// Inference 1: the only state gets a counterpart without an event, ordered first.
InferredRest add_rest_state(Unit& unit) {
  State rest;
  rest.name = "NOT_" + unit.states.front().name;
  unit.states.insert(unit.states.begin(), std::move(rest));
  unit.rest_added = true;
  return {0, unit.states[1].operation != kNone};
}

/// Inference 2: of two states one has an operation and the other only a sensor.
InferredRest infer_single_solenoid(Unit& unit, UnitEvidence& evidence) {
  for (std::uint32_t x = 0; x < 2; ++x) {
    const std::uint32_t y = 1 - x;
    const State& commanded = unit.states[x];
    const State& other = unit.states[y];
    if (commanded.operation == kNone || other.operation != kNone) continue;
    evidence.two_words = commanded.event == kNone && other.event != kNone;
    if (commanded.event == kNone || other.numbered) continue;
    unit.single_solenoid = true;
    return {y, true};
  }
  return {};
}

void choose_actuation_and_rest(Unit& unit, const description::Defaults& defaults, UnitEvidence& evidence,
                               description::Faults& faults) {
  InferredRest inferred;
  if (unit.states.size() == 1 && !is_placeholder(unit)) {
    inferred = add_rest_state(unit);
  } else if (unit.states.size() == 2 && !unit.is_archetype()) {
    inferred = infer_single_solenoid(unit, evidence);
  }
  unit.actuation = inferred.spring ? tables::Actuation::spring : defaults.actuation;
  unit.rest = inferred.rest;
  const description::DeviceDescription* given = unit.described;
  if (given == nullptr) return;
  if (given->actuation) unit.actuation = *given->actuation;
  if (!given->rest) return;
  const description::Pointer here = description::key_pointer(*given, description::DeviceKey::rest);
  const std::uint32_t rest = given_state(unit, *given->rest, here, faults);
  if (rest == kNone) return;
  if (unit.actuation != tables::Actuation::spring) {
    if (given->entry_of(description::DeviceKey::rest).by_naming) return;  // plant.json gives another actuation
    faults.add(here, description::ticked(unit.path) + " is `" +
                         std::string(description::actuation_name(unit.actuation)) +
                         "`, but only a `spring` has a rest state; remove `rest` or set `actuation` to `spring`");
    return;
  }
  unit.rest = rest;
}

std::uint32_t state_by_initial_column(const Unit& unit, const std::vector<Symbol>& symbols, UnitEvidence& evidence) {
  std::uint32_t candidate = kNone;
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const std::uint32_t event = unit.states[s].event;
    if (event == kNone || symbols[unit.events[event]].initial == 0 || symbols[unit.events[event]].inverted) continue;
    candidate = s;
    ++evidence.initial_candidates;
  }
  return evidence.initial_candidates == 1 ? candidate : kNone;
}

/// Whether more than the order of rows decides the first state of S.
bool first_is_decided(const std::vector<State>& states) {
  const auto by_symbol = [](const State& s) { return s.operation != kNone || s.event != kNone; };
  if (states.size() == 1 || !by_symbol(states[1])) return true;
  return states[0].numbered && sequence_number(states[0].name) != sequence_number(states[1].name);
}

void choose_initial(Unit& unit, const std::vector<Symbol>& symbols, UnitEvidence& evidence,
                    description::Faults& faults) {
  std::uint32_t initial = kNone;
  if (unit.described != nullptr && unit.described->initial) {
    initial = given_state(unit, *unit.described->initial,
                          description::key_pointer(*unit.described, description::DeviceKey::initial), faults);
    const bool by_naming = unit.described->entry_of(description::DeviceKey::initial).by_naming;
    if (initial != kNone) unit.initial_from = by_naming ? InitialFrom::naming : InitialFrom::description;
  }
  if (initial == kNone) {
    initial = state_by_initial_column(unit, symbols, evidence);
    unit.initial_from = InitialFrom::initial_column;
  }
  if (initial == kNone) {
    initial = unit.rest;
    unit.initial_from = InitialFrom::rest_state;
  }
  if (initial == kNone) {
    initial = 0;
    const bool rest_first = unit.facet != nullptr && unit.facet->first_is_rest;
    unit.initial_from = rest_first                      ? InitialFrom::naming
                        : first_is_decided(unit.states) ? InitialFrom::sequence
                                                        : InitialFrom::row_order;
  }
  unit.initial = initial;
  if (unit.actuation == tables::Actuation::spring && unit.rest == kNone) unit.rest = initial;
}

void choose_overrun(Unit& unit, tables::Time usual, description::Faults& faults) {
  const bool held = unit.actuation == tables::Actuation::held;
  const auto given = unit.described == nullptr ? std::nullopt : unit.described->overrun;
  if (held) unit.overrun = given.value_or(usual);
  if (held || !given || unit.described->entry_of(description::DeviceKey::overrun).is_pattern()) return;
  faults.add(description::key_pointer(*unit.described, description::DeviceKey::overrun),
             description::ticked(unit.path) + " is `" + std::string(description::actuation_name(unit.actuation)) +
                 "`, but only a `held` device can overrun; remove `overrun` or set `actuation` to `held`");
}

/// Numbered states sorted by number; equal numbers in the order of S.
std::vector<std::uint32_t> by_number(const std::vector<State>& states) {
  std::vector<std::uint32_t> numbered;
  for (std::uint32_t s = 0; s < states.size(); ++s) {
    if (!states[s].numbered) continue;
    if (numbered.empty()) numbered.reserve(states.size() - s);
    numbered.push_back(s);
  }
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    return compare_sequence(sequence_number(states[a].name), sequence_number(states[b].name)) < 0;
  };
  // Mostly they are: S is sorted by number. Sorting takes memory.
  if (!std::is_sorted(numbered.begin(), numbered.end(), is_before))
    std::stable_sort(numbered.begin(), numbered.end(), is_before);
  return numbered;
}

/// Which numbered states derived transitions join.
class Joins {
 public:
  /// `numbered` is that of by_number().
  Joins(const Unit& unit, const std::vector<std::uint32_t>& numbered, description::Sequence sequence)
      : sequence_(sequence) {
    if (sequence == description::Sequence::free || numbered.empty()) return;
    ranks_.assign(unit.states.size(), kNone);
    std::string_view before;
    for (const std::uint32_t s : numbered) {
      const std::string_view number = sequence_number(unit.states[s].name);
      if (numbers_ == 0 || compare_sequence(before, number) != 0) ++numbers_;
      before = number;
      ranks_[s] = numbers_ - 1;
    }
  }

  bool operator()(std::uint32_t from, std::uint32_t to) const {
    if (numbers_ == 0 || ranks_[from] == kNone || ranks_[to] == kNone) return true;
    if (sequence_ == description::Sequence::cycle) return ranks_[to] == (ranks_[from] + 1) % numbers_;
    return ranks_[to] == ranks_[from] + 1 || ranks_[from] == ranks_[to] + 1;
  }

 private:
  description::Sequence sequence_;
  std::vector<std::uint32_t> ranks_;  ///< by state: the index of its number among the unit's; kNone without a number
  std::uint32_t numbers_ = 0;
};

description::Sequence sequence_of(const Unit& unit, const description::Defaults& defaults,
                                  description::Faults& faults) {
  if (unit.described == nullptr || !unit.described->sequence) return defaults.sequence;
  const description::Sequence sequence = *unit.described->sequence;
  const bool numbered = std::any_of(unit.states.begin(), unit.states.end(), [](const State& s) { return s.numbered; });
  const bool exact = !unit.described->entry_of(description::DeviceKey::sequence).is_pattern();
  if (sequence != description::Sequence::free && !numbered && exact) {
    faults.add(description::key_pointer(*unit.described, description::DeviceKey::sequence),
               description::ticked(unit.path) + " has no numbered states; remove `sequence`");
  }
  return sequence;
}

/// Every operation O_X from every state A other than X that it joins, ordered by target in S, then by source.
void derive_commanded(Unit& unit, const GivenTransitions& given, const Joins& joins) {
  const auto count = static_cast<std::uint32_t>(unit.states.size());
  const description::Duration takes = description::Duration::fixed(unit.travel);
  if (unit.transitions.empty()) unit.transitions.reserve(unit.operations.size() * (count - 1));
  for (std::uint32_t to = 0; to < count; ++to) {
    const std::uint32_t on = unit.states[to].operation;
    if (on == kNone) continue;
    for (std::uint32_t from = 0; from < count; ++from) {
      if (from == to || !joins(from, to) || given.commanded(from, on)) continue;
      unit.transitions.push_back({from, to, on, description::Duration{}, takes, Origin::derived});
    }
  }
}

/// Inference 3: a numbered state with an event and no operation follows automatically after its predecessor.
/// `numbered` is that of by_number(): groups of one number are runs.
void infer_sequence(Unit& unit, const std::vector<std::uint32_t>& numbered, const GivenTransitions& given,
                    tables::Time dwell, UnitEvidence& evidence) {
  if (unit.actuation != tables::Actuation::latched) return;
  const auto has_operation = [&](std::uint32_t s) { return unit.states[s].operation != kNone; };
  if (std::none_of(numbered.begin(), numbered.end(), has_operation)) return;

  const auto number = [&](std::size_t i) { return sequence_number(unit.states[numbered[i]].name); };
  const auto group_begin = [&](std::size_t i) {
    while (i > 0 && number(i - 1) == number(i)) --i;
    return i;
  };
  for (std::size_t i = 0; i < numbered.size(); ++i) {
    const std::uint32_t to = numbered[i];
    if (unit.states[to].event == kNone || unit.states[to].operation != kNone || given.led_to(to)) continue;
    const std::size_t begin = group_begin(i);
    const std::size_t last = begin > 0 ? begin - 1 : numbered.size() - 1;  // from the lowest back to the highest
    const std::uint32_t from = numbered[last];
    if (group_begin(last) != last) {
      evidence.ambiguous_sequence.push_back(to);
    } else if (from != to && !given.automatic(from, to)) {
      unit.transitions.push_back(
          {from, to, kNone, description::Duration::fixed(dwell), description::Duration{}, Origin::inferred});
    }
  }
}

}  // namespace

UnitEvidence derive_states(Unit& unit, const std::vector<Symbol>& symbols, const description::Defaults& defaults,
                           description::Faults& faults) {
  UnitEvidence evidence;
  const description::DeviceDescription* described = unit.described;
  unit.travel = defaults.travel;
  unit.states = states_of(unit, symbols, TaskRoles(unit, symbols));
  if (described != nullptr) add_given_states(unit, faults);
  sort_by_facet(unit);
  // All tasks are commands and reports of states that do not exist, which is reported elsewhere.
  if (unit.states.empty()) unit.states = states_of(unit, symbols, TaskRoles());
  if (unit.states.empty()) unit.states.push_back({std::string(kOnlyState)});  // of a device without states
  choose_actuation_and_rest(unit, defaults, evidence, faults);
  choose_initial(unit, symbols, evidence, faults);
  choose_overrun(unit, defaults.overrun, faults);
  return evidence;
}

void derive_transitions(Unit& unit, const std::vector<Symbol>& symbols, const description::Defaults& defaults,
                        UnitEvidence& evidence, description::Faults& faults) {
  const description::DeviceDescription* described = unit.described;
  if (described != nullptr) add_given_transitions(unit, symbols, faults);
  if (described == nullptr || !described->only) {
    const GivenTransitions given(unit);
    const std::vector<std::uint32_t> numbered = by_number(unit.states);
    derive_commanded(unit, given, Joins(unit, numbered, sequence_of(unit, defaults, faults)));
    infer_sequence(unit, numbered, given, defaults.dwell, evidence);
  }
  if (unit.transitions.size() > tables::kMaxTransitions) {  // never without given ones
    unit.transitions.resize(tables::kMaxTransitions);
    faults.add(description::key_pointer(*described, description::DeviceKey::transitions),
               "the device has more than " + std::to_string(tables::kMaxTransitions) +
                   " transitions, where a `*` counts once for each state; remove some");
  }
  if (described != nullptr) add_outputs(unit, symbols, faults);
  // A word that is reached automatically is not a slip of the other (O_RUN1, I_DONE2).
  for (std::uint32_t s = 0; evidence.two_words && s < 2; ++s) {
    if (unit.states[s].operation == kNone && unit.reaches(s)) evidence.two_words = false;
  }
}

}  // namespace symplant::model
