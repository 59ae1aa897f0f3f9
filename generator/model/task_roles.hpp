// Which tasks of a unit are states: all but those that its description makes mere commands or mere reports.
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

/// What a description says of tasks. Views point into it.
class TaskRoles {
 public:
  TaskRoles() = default;  ///< every task is a state
  /// By what is said of the unit's device, but for what a pattern says and the unit's symbols lack. `symbols` are the
  /// plant's. O(description of the device and symbols of the unit).
  TaskRoles(const Unit& unit, const std::vector<Symbol>& symbols);

  TaskRole of(std::string_view task, bool has_operation, bool has_event) const;

 private:
  using Tasks = std::unordered_set<std::string_view, text::HashIgnoringCase, text::EqualIgnoringCase>;
  Tasks states_;    ///< named where only a state can stand
  Tasks commands_;  ///< `on` of a transition
  Tasks switched_;  ///< by outputs
};

}  // namespace symplant::model
