// A scenario's steps, their names looked up in the plant.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "property/files/file_case.hpp"
#include "support/reference/scenario.hpp"

namespace symplant::property::files {

/// Looks up names. What it gives points into it.
class StepResolver {
 public:
  /// `plant` must outlive it.
  explicit StepResolver(const model::PlantModel& plant) : plant_(plant) {}

  /// Nothing where the plant lacks what the step names.
  std::optional<reference::ScenarioStep> resolve(const Step& step);
  /// Null where it is no condition over the plant.
  const condition::Tree* condition(const std::string& text);

 private:
  bool settings(const std::vector<Setting>& from, std::vector<std::pair<std::uint32_t, std::uint64_t>>& to) const;

  const model::PlantModel& plant_;
  std::map<std::string, const condition::Tree*> conditions_;
  std::deque<condition::Tree> trees_;
};

}  // namespace symplant::property::files
