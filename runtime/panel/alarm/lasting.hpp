// Whether what a finding reported still lasts.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "symplant/tables/finding.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/conditions.hpp"

namespace symplant::panel {

/// Used by one thread at a time, together with a History. Both arguments must outlive it.
class Lasting {
 public:
  Lasting(const trace::PlantNames& names, const trace::History& history) : names_(names), history_(history) {}

  /// Whether the situation of a finding lasts according to the history: the conflicting commands are on, the device is
  /// stopped midway, the condition of `never` holds, that of `expect` does not. False for what has no end, such as an
  /// event that was too short, and for a link. `about`: as trace::FoundThing::of. O(operations of the device or inputs
  /// of the condition); O(plant) for the first requirement.
  bool lasts(tables::FindingKind kind, std::span<const std::uint32_t> about, tables::Time now);

 private:
  bool of_unit(tables::FindingKind kind, std::uint32_t unit) const;
  bool of_requirement(std::uint32_t requirement, tables::Time now);

  const trace::PlantNames& names_;
  const trace::History& history_;
  std::optional<why::Conditions> conditions_;
  std::map<std::uint32_t, why::Network> networks_;  ///< by requirement
};

}  // namespace symplant::panel
