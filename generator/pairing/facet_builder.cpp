// Makes a facet of symbols that lead to states or report them.
#include "pairing/facet_builder.hpp"

#include <algorithm>
#include <utility>

#include "pairing/device_words.hpp"

namespace symplant::pairing {
namespace {

constexpr std::size_t kFewStates = 8;  ///< up to here a linear search is fastest

bool is_empty(const description::DeviceDescription& base) {
  return !base.actuation && base.transitions.empty() && base.outputs.empty();
}

}  // namespace

void FacetBuilder::add(std::uint32_t input, std::string_view state, bool rest) {
  StateDraft& draft = state_of(state, rest);
  (work_.is_operation(input) ? draft.operations : draft.events).push_back(input);
}

void FacetBuilder::add_again(std::uint32_t event, std::string_view state) {
  shared_ = true;
  add(event, state, false);
}

FacetBuilder::StateDraft& FacetBuilder::state_of(std::string_view name, bool rest) {
  if (states_.size() <= kFewStates) {
    for (StateDraft& state : states_) {
      if (text::equal_ignoring_case(state.name, name)) return state;
    }
  } else {
    for (std::size_t i = by_name_.size(); i < states_.size(); ++i) by_name_.emplace(states_[i].name, i);
    if (const auto found = by_name_.find(name); found != by_name_.end()) return states_[found->second];
  }
  return states_.emplace_back(StateDraft{std::string(name), rest, {}, {}});
}

Facet FacetBuilder::take(std::uint32_t device, bool numbered) {
  device_ = device;
  Facet facet;
  facet.numbered = numbered;
  description::DeviceDescription base;
  if (!numbered) {
    sort_states(facet);
    add_spring(base);
  }
  add_operations(facet, base);
  add_events(facet, base);
  std::sort(facet.members.begin(), facet.members.end(),
            [](const Member& a, const Member& b) { return a.input < b.input; });
  base.by_naming = true;
  if (!is_empty(base)) facet.base = std::make_shared<const description::DeviceDescription>(std::move(base));
  states_.clear();
  by_name_.clear();
  taken_.clear();
  shared_ = false;
  return facet;
}

void FacetBuilder::sort_states(Facet& facet) {
  std::stable_sort(states_.begin(), states_.end(),
                   [](const StateDraft& a, const StateDraft& b) { return a.rest && !b.rest; });
  facet.first_is_rest = states_.front().rest && states_.size() > 1 && !states_[1].rest;
  facet.states.reserve(states_.size());
  for (const StateDraft& state : states_) facet.states.push_back(state.name);
}

/// The first operation of a state has its name. Further ones are commands that lead to it.
void FacetBuilder::add_operations(Facet& facet, description::DeviceDescription& base) {
  for (const StateDraft& state : states_) {
    for (std::size_t i = 0; i < state.operations.size(); ++i) {
      const std::uint32_t input = state.operations[i];
      if (i == 0) {
        facet.members.push_back({input, state.name});
        continue;
      }
      std::string task = further_task(input);
      base.transitions.push_back({"*", state.name, task, {}, false, false, {}, {}});
      facet.members.push_back({input, std::move(task)});
    }
  }
}

/// The first event of a state has its name. Further ones are switched when the state is entered and left.
void FacetBuilder::add_events(Facet& facet, description::DeviceDescription& base) {
  std::unordered_map<std::uint32_t, std::string> known;  // events with a task, if some have several states
  for (const StateDraft& state : states_) {
    description::GivenOutputs outputs{state.name, {}, {}};
    bool named = false;
    for (const std::uint32_t input : state.events) {
      const auto found = shared_ ? known.find(input) : known.end();
      std::string task = found != known.end() ? found->second : named ? further_task(input) : state.name;
      if (found == known.end()) {
        facet.members.push_back({input, task});
        if (shared_) known.emplace(input, task);
        if (!std::exchange(named, true)) continue;
      }
      outputs.enter.emplace_back(task, true);
      outputs.leave.emplace_back(std::move(task), false);
    }
    if (!outputs.enter.empty()) base.outputs.push_back(std::move(outputs));
  }
}

/// Of two states one has a command, and something reports the other or both: without the command the device returns.
void FacetBuilder::add_spring(description::DeviceDescription& base) const {
  if (states_.size() != 2) return;
  const bool first = !states_[0].operations.empty();
  const bool second = !states_[1].operations.empty();
  if (first == second) return;
  base.actuation = tables::Actuation::spring;
  base.rest = states_[first ? 1 : 0].name;
}

std::string FacetBuilder::further_task(std::uint32_t input) {
  if (!work_.is_read(input)) return unique(std::string(work_.inputs[input].name));
  const name::RuleReading& reading = work_.reading(input);
  std::string task;
  if (work_.is_read(device_) && work_.device[device_] != work_.device[input]) {
    const std::string_view own = work_.reading(device_).device;
    for_each_word(reading.device, [&](std::string_view word) {
      if (!has_word(own, word)) task.append(word).push_back('_');
    });
  }
  return unique(task + joined_words(reading.task.text));
}

std::string FacetBuilder::unique(std::string task) {
  if (taken_.empty()) {
    for (const StateDraft& state : states_) taken_.emplace(state.name, 1);
  }
  std::size_t& last = taken_.try_emplace(task, 0).first->second;
  if (++last == 1) return task;
  for (std::string numbered;; ++last) {
    numbered = task + "_" + std::to_string(last);
    if (taken_.try_emplace(numbered, 1).second) return numbered;
  }
}

}  // namespace symplant::pairing
