// Makes a facet of symbols that lead to states or report them.
#include "pairing/facet_builder.hpp"

#include <algorithm>
#include <utility>

#include "pairing/device_words.hpp"

namespace symplant::pairing {
namespace {

constexpr std::size_t kFewStates = 8;  ///< up to here a linear search is fastest

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
  if (count_ <= kFewStates) {
    for (StateDraft& state : states()) {
      if (text::equal_ignoring_case(state.name, name)) return state;
    }
  } else {
    for (std::size_t i = by_name_.size(); i < count_; ++i) by_name_.emplace(states_[i].name, i);
    if (const auto found = by_name_.find(name); found != by_name_.end()) return states_[found->second];
  }
  if (count_ == states_.size()) states_.emplace_back();
  StateDraft& added = states_[count_++];
  added.name.assign(name);
  added.rest = rest;
  added.operations.clear();
  added.events.clear();
  return added;
}

Facet FacetBuilder::take(std::uint32_t device, bool numbered) {
  device_ = device;
  Facet facet;
  facet.numbered = numbered;
  if (!numbered) sort_states(facet);
  std::size_t symbols = 0;
  for (const StateDraft& state : states()) symbols += state.operations.size() + state.events.size();
  facet.members.reserve(symbols);
  add_operations(facet);
  add_events(facet);
  std::sort(facet.members.begin(), facet.members.end(),
            [](const Member& a, const Member& b) { return a.input < b.input; });
  const std::uint32_t rest = numbered ? kNone : rest_of_spring();
  if (rest != kNone || !further_.empty()) facet.base = base(rest);
  count_ = 0;
  by_name_.clear();
  taken_.clear();
  further_.clear();
  unnamed_.clear();
  shared_ = false;
  return facet;
}

void FacetBuilder::sort_states(Facet& facet) {
  std::stable_sort(states().begin(), states().end(),
                   [](const StateDraft& a, const StateDraft& b) { return a.rest && !b.rest; });
  facet.first_is_rest = count_ > 1 && states_[0].rest && !states_[1].rest;
  facet.states.reserve(count_);
  for (const StateDraft& state : states()) facet.states.push_back(state.name);
}

/// The first operation of a state has its name. Further ones are commands that lead to it.
void FacetBuilder::add_operations(Facet& facet) {
  for (std::uint32_t s = 0; s < count_; ++s) {
    bool named = false;
    for (const std::uint32_t input : states_[s].operations) {
      if (!std::exchange(named, true)) {
        facet.members.push_back({input, states_[s].name});
      } else {
        further_.push_back({true, s, further_task(input)});
        facet.members.push_back({input, further_.back().task});
      }
    }
  }
}

/// The first event of a state has its name. Further ones are switched when the state is entered and left.
void FacetBuilder::add_events(Facet& facet) {
  std::unordered_map<std::uint32_t, std::string> known;  // events with a task, if some have several states
  for (std::uint32_t s = 0; s < count_; ++s) {
    bool named = false;
    for (const std::uint32_t input : states_[s].events) {
      const auto found = shared_ ? known.find(input) : known.end();
      std::string task = found != known.end() ? found->second : named ? further_task(input) : states_[s].name;
      if (found == known.end()) {
        facet.members.push_back({input, task});
        if (shared_) known.emplace(input, task);
        if (!std::exchange(named, true)) continue;
      }
      further_.push_back({false, s, std::move(task)});
    }
    if (!named && states_[s].operations.empty()) unnamed_.push_back(s);
  }
}

/// Of two states one has a command, and something reports the other or both: without the command the device returns.
std::uint32_t FacetBuilder::rest_of_spring() const {
  if (count_ != 2) return kNone;
  const bool first = !states_[0].operations.empty();
  const bool second = !states_[1].operations.empty();
  return first == second ? kNone : first ? 1 : 0;
}

std::shared_ptr<const description::DeviceDescription> FacetBuilder::base(std::uint32_t rest) {
  std::string key;
  const auto add = [&](std::string_view text) { key.append(text).push_back('\0'); };
  add(rest == kNone ? std::string_view() : std::string_view(states_[rest].name));
  for (const std::uint32_t state : unnamed_) add(states_[state].name);
  for (const Further& further : further_) {
    add(further.operation ? "O" : "I");
    add(states_[further.state].name);
    add(further.task);
  }
  const auto [found, added] = bases_.try_emplace(std::move(key));
  if (!added) return found->second;
  description::DeviceDescription base;
  base.by_naming = true;
  if (rest != kNone) {
    base.actuation = tables::Actuation::spring;
    base.rest = states_[rest].name;
  }
  for (const std::uint32_t state : unnamed_) base.states.push_back(states_[state].name);
  for (const Further& further : further_) {
    const std::string& state = states_[further.state].name;
    if (further.operation) {
      base.transitions.push_back({"*", state, further.task, {}, false, false, {}, {}});
      continue;
    }
    if (base.outputs.empty() || base.outputs.back().state != state) base.outputs.push_back({state, {}, {}});
    base.outputs.back().enter.emplace_back(further.task, true);
    base.outputs.back().leave.emplace_back(further.task, false);
  }
  found->second = std::make_shared<const description::DeviceDescription>(std::move(base));
  return found->second;
}

std::string FacetBuilder::further_task(std::uint32_t input) {
  if (!work_.is_read(input)) return unique(std::string(work_.inputs[input].name));
  const name::Reading& reading = work_.reading(input);
  std::string task;
  if (work_.is_read(device_) && work_.device[device_] != work_.device[input]) {
    const std::string_view own = work_.reading(device_).levels->device;
    for_each_word(reading.levels->device, [&](std::string_view word) {
      if (!has_word(own, word)) task.append(word).push_back('_');
    });
  }
  return unique(task + joined_words(reading.task->text));
}

std::string FacetBuilder::unique(std::string task) {
  if (taken_.empty()) {
    for (const StateDraft& state : states()) taken_.emplace(state.name, 1);
  }
  std::size_t& last = taken_.try_emplace(task, 0).first->second;
  if (++last == 1) return task;
  for (std::string numbered;; ++last) {
    numbered = task + "_" + std::to_string(last);
    if (taken_.try_emplace(numbered, 1).second) return numbered;
  }
}

}  // namespace symplant::pairing
