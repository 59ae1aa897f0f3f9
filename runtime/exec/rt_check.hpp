// --rt-check: a plant's cycles under the guard, and who broke the rules in words.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/exec/guard/guard.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::exec {

/// The same behaviours, telling the guard whose code runs. A plant is made of watched() in place of them; it must not
/// outlive this. `tables` must outlive it.
class WatchedBehaviours {
 public:
  WatchedBehaviours(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours);

  std::span<const engine::Behaviour> watched() const noexcept { return all_; }

 private:
  std::vector<engine::Behaviour> all_;  ///< those that tell, then those that they call, a behaviour each
};

/// What a watched run was found to do, a line for each act of each function: "heap: operator new, in `entered` of
/// behaviour `MyStopper`, device L_P_STOPPER1, 12 times (first from main)". Then what could not be looked at. Names are
/// as in the tables: not made fit for a terminal yet.
std::vector<std::string> rt_check_lines(const GuardReport& report, const tables::PlantTables& tables);

}  // namespace symplant::exec
