// For --rt-check: custom behaviors under the guard, and the report of violations.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/exec/guard/guard.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::exec {

/// Wraps custom behaviors, so that the guard records which behavior runs. Make the plant with watched() instead of the
/// original behaviors. This object must outlive the plant.
class WatchedBehaviours {
 public:
  WatchedBehaviours(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours);

  std::span<const engine::Behaviour> watched() const noexcept { return all_; }

 private:
  std::vector<engine::Behaviour> all_;  ///< the wrappers, then the originals, one of each per name
};

/// The violations of a watched run, one line for each kind of violation of each function: "heap: operator new, in
/// `entered` of behavior `MyStopper`, device L_P_STOPPER1, 12 times (called from main)". Then what could not be
/// checked. Names are as in the tables: the caller must escape them for a terminal.
std::vector<std::string> rt_check_lines(const GuardReport& report, const tables::PlantTables& tables);

}  // namespace symplant::exec
