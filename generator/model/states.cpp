// S: the tasks that symbols name, then the states that the description adds.
#include "model/states.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "model/sequence.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

struct Draft {
  std::string_view task;
  std::string_view sequence;
  std::uint32_t first_symbol;
  std::uint32_t operation = kNone;
  std::uint32_t event = kNone;
};

/// Drafts by task. Most units have so few that a linear search is fastest.
class Drafts {
 public:
  explicit Drafts(std::size_t symbols) { drafts_.reserve(symbols); }

  Draft& of(std::string_view task, std::uint32_t symbol) {
    if (drafts_.size() <= kFew) {
      for (Draft& draft : drafts_) {
        if (text::equal_ignoring_case(draft.task, task)) return draft;
      }
    } else {
      for (std::size_t i = by_task_.size(); i < drafts_.size(); ++i) by_task_.emplace(drafts_[i].task, i);
      if (const auto found = by_task_.find(task); found != by_task_.end()) return drafts_[found->second];
    }
    return drafts_.emplace_back(Draft{task, sequence_number(task), symbol});
  }

  std::vector<Draft> take() { return std::move(drafts_); }

 private:
  static constexpr std::size_t kFew = 16;

  std::vector<Draft> drafts_;
  text::ByName<std::size_t> by_task_;
};

std::vector<Draft> drafts_of(const Unit& unit, const std::vector<Symbol>& symbols) {
  Drafts drafts(unit.operations.size() + unit.events.size());
  const auto add = [&](std::uint32_t symbol) -> Draft& { return drafts.of(symbols[symbol].reading.task(), symbol); };
  for (std::uint32_t i = 0; i < unit.operations.size(); ++i) add(unit.operations[i]).operation = i;
  for (std::uint32_t i = 0; i < unit.events.size(); ++i) {
    Draft& draft = add(unit.events[i]);
    draft.event = i;
    if (unit.events[i] < draft.first_symbol) {  // the first row names the state
      draft.first_symbol = unit.events[i];
      draft.task = symbols[unit.events[i]].reading.task();
    }
  }
  return drafts.take();
}

const State* find_state(const std::vector<State>& states, std::string_view name) {
  const auto found = std::find_if(states.begin(), states.end(),
                                  [&](const State& s) { return text::equal_ignoring_case(s.name, name); });
  return found == states.end() ? nullptr : &*found;
}

}  // namespace

std::vector<State> states_of(const Unit& unit, const std::vector<Symbol>& symbols, const TaskRoles& roles) {
  std::vector<Draft> drafts = drafts_of(unit, symbols);
  if (unit.described != nullptr || !unit.reports.empty()) {
    std::erase_if(drafts, [&](const Draft& draft) {
      if (roles.of(draft.task, draft.operation != kNone, draft.event != kNone) != TaskRole::state) return true;
      return draft.operation == kNone && unit.is_report(unit.events[draft.event]) && !roles.names_state(draft.task);
    });
  }
  if (!unit.has_sequence()) {
    for (Draft& draft : drafts) draft.sequence = {};
  }
  std::sort(drafts.begin(), drafts.end(), [](const Draft& a, const Draft& b) {
    const int order = compare_sequence(a.sequence, b.sequence);
    return order != 0 ? order < 0 : a.first_symbol < b.first_symbol;
  });
  std::vector<State> states;
  states.reserve(std::max<std::size_t>(drafts.size(), 2));  // the only one gets a counterpart
  for (const Draft& draft : drafts) {
    states.push_back({std::string(draft.task), draft.operation, draft.event, !draft.sequence.empty()});
  }
  return states;
}

void sort_by_facet(Unit& unit) {
  if (unit.facet == nullptr || unit.facet->states.empty()) return;
  text::ByName<std::size_t> ranks;
  for (const std::string& state : unit.facet->states) ranks.try_emplace(state, ranks.size());
  const auto rank = [&](const State& state) {
    const auto found = ranks.find(state.name);
    return found == ranks.end() ? ranks.size() : found->second;
  };
  std::stable_sort(unit.states.begin(), unit.states.end(),
                   [&](const State& a, const State& b) { return rank(a) < rank(b); });
}

void add_given_states(Unit& unit, description::Faults& faults) {
  const std::vector<std::string>& given = unit.described->states;
  const description::Pointer pointer = description::key_pointer(*unit.described, description::DeviceKey::states);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const description::Pointer here = pointer / i;
    const State* same = find_state(unit.states, given[i]);
    if (same != nullptr && same->event != kNone && unit.is_report(unit.events[same->event])) continue;
    if (same != nullptr) {
      const bool by_symbol = same->operation != kNone || same->event != kNone;
      faults.add(here, description::ticked(given[i]) +
                           (by_symbol ? " is already a state of " + description::ticked(unit.path) + " by its symbols"
                                      : " appears twice") +
                           "; remove it");
    } else if (given[i].empty() || given[i] == "*") {
      faults.add(here, description::ticked(given[i]) + " is not a valid name of a state; choose another");
    } else if (unit.states.size() == tables::kMaxStates) {
      faults.add(pointer, "the device has more than " + std::to_string(tables::kMaxStates) +
                              " states, including those of its symbols; remove some");
      return;
    } else {
      const bool numbered = unit.has_sequence() && !sequence_number(given[i]).empty();
      unit.states.push_back({given[i], kNone, kNone, numbered});
    }
  }
}

}  // namespace symplant::model
