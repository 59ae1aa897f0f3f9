// A scenario's steps with their names looked up in the plant.
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

/// Looks up names. Its results point into it.
class StepResolver {
 public:
  /// `plant` must outlive it.
  explicit StepResolver(const model::PlantModel& plant) : plant_(plant) {}

  /// Nothing if the plant lacks a name of the step.
  std::optional<reference::ScenarioStep> resolve(const Step& step);
  /// Null if it is not a condition over the plant.
  const condition::Tree* condition(const std::string& text);

 private:
  bool malfunctions(const std::vector<std::string>& names, std::vector<std::uint32_t>& to) const;
  bool settings(const std::vector<Setting>& from, std::vector<std::pair<std::uint32_t, std::uint64_t>>& to) const;

  const model::PlantModel& plant_;
  std::map<std::string, const condition::Tree*> conditions_;
  std::deque<condition::Tree> trees_;
};

}  // namespace symplant::property::files
