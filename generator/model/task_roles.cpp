// Which tasks are states.
#include "model/task_roles.hpp"

namespace symplant::model {

TaskRoles::TaskRoles(const DeviceDescription* device) {
  if (device == nullptr) return;
  for (const GivenTransition& given : device->transitions) {
    states_.insert({given.from, given.to});
    if (!given.on.empty()) commands_.insert(given.on);
  }
  states_.insert(device->states.begin(), device->states.end());
  if (device->initial) states_.insert(*device->initial);
  if (device->rest) states_.insert(*device->rest);
  for (const GivenDisables& given : device->disables) states_.insert(given.state);
  for (const GivenOutputs& given : device->outputs) {
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
