// Decides which tasks of a unit are states: all except those that its description makes only commands or reports.
#pragma once

#include <string_view>
#include <unordered_set>

#include "model/plant_model.hpp"
#include "text/ascii.hpp"

namespace symplant::model {

enum class TaskRole : std::uint8_t {
  state,
  command,  ///< an operation without event that only commands given transitions (O_HOME)
  report,   ///< an event without operation that only `outputs` switch (I_BUSY)
};

/// The roles of tasks in a description. Views point into it.
class TaskRoles {
 public:
  TaskRoles() = default;  ///< every task is a state
  /// From the description of the unit's device, without the names of a pattern that the unit lacks. `symbols` are the
  /// plant's. O(description of the device and symbols of the unit).
  TaskRoles(const Unit& unit, const std::vector<Symbol>& symbols);

  TaskRole of(std::string_view task, bool has_operation, bool has_event) const;
  /// Whether the description names it as a state.
  bool names_state(std::string_view task) const { return states_.contains(task); }

 private:
  using Tasks = std::unordered_set<std::string_view, text::HashIgnoringCase, text::EqualIgnoringCase>;
  Tasks states_;    ///< named as a state
  Tasks commands_;  ///< named by `on` of a transition
  Tasks switched_;  ///< switched by outputs
};

}  // namespace symplant::model
