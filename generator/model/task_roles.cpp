// Decides which tasks are states.
#include "model/task_roles.hpp"

namespace symplant::model {

namespace {

/// The tasks of a unit's symbols and its added states.
class UnitTasks {
 public:
  UnitTasks(const Unit& unit, const std::vector<Symbol>& symbols) {
    for (const std::uint32_t symbol : unit.operations) operations_.insert(symbols[symbol].reading.task());
    for (const std::uint32_t symbol : unit.events) events_.insert(symbols[symbol].reading.task());
    states_.insert(unit.described->states.begin(), unit.described->states.end());
  }

  /// False if the unit certainly lacks a state. (A NOT_X may be added later.)
  bool may_be_state(std::string_view name) const {
    return is_task(name) || states_.contains(name) ||
           (name.size() > 4 && text::equal_ignoring_case(name.substr(0, 4), "NOT_") && is_task(name.substr(4)));
  }
  /// False if the unit certainly lacks a name of the transition.
  bool allow(const description::GivenTransition& given) const {
    return (given.from == "*" || may_be_state(given.from)) && may_be_state(given.to) &&
           (given.on.empty() || operations_.contains(given.on));
  }

 private:
  using Tasks = std::unordered_set<std::string_view, text::HashIgnoringCase, text::EqualIgnoringCase>;

  bool is_task(std::string_view name) const { return operations_.contains(name) || events_.contains(name); }

  Tasks operations_;
  Tasks events_;
  Tasks states_;
};

}  // namespace

TaskRoles::TaskRoles(const Unit& unit, const std::vector<Symbol>& symbols) {
  const description::DeviceDescription* device = unit.described;
  if (device == nullptr) return;
  std::optional<UnitTasks> tasks;
  const bool transitions_lackable = device->entry_of(description::DeviceKey::transitions).is_pattern();
  const bool outputs_lackable = device->entry_of(description::DeviceKey::outputs).is_pattern();
  if (transitions_lackable || outputs_lackable) tasks.emplace(unit, symbols);
  for (const description::GivenTransition& given : device->transitions) {
    if (transitions_lackable && !tasks->allow(given)) continue;
    states_.insert({given.from, given.to});
    if (!given.on.empty()) commands_.insert(given.on);
  }
  states_.insert(device->states.begin(), device->states.end());
  if (device->initial) states_.insert(*device->initial);
  if (device->rest) states_.insert(*device->rest);
  for (const description::GivenDisables& given : device->disables) states_.insert(given.state);
  for (const description::GivenOutputs& given : device->outputs) {
    if (outputs_lackable && !tasks->may_be_state(given.state)) continue;
    states_.insert(given.state);
    for (const auto* list : {&given.enter, &given.leave}) {
      for (const auto& [task, on] : *list) switched_.insert(task);
    }
  }
}

TaskRole TaskRoles::of(std::string_view task, bool has_operation, bool has_event) const {
  if (has_operation == has_event) return TaskRole::state;
  const Tasks& mere = has_operation ? commands_ : switched_;
  if (!mere.contains(task) || states_.contains(task)) return TaskRole::state;
  return has_operation ? TaskRole::command : TaskRole::report;
}

}  // namespace symplant::model
