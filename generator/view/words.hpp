// Words for what a model holds, the same in every view.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::view {

/// "1.5 s", "500 ms", "1500 ns": exactly.
std::string time_text(tables::Time time);
/// "1 s", "1 s to 2 s", "1 s (sigma 20 ms)".
std::string duration_text(const description::Duration& duration);

/// `given`, `derived` or `inferred`.
std::string_view origin_text(model::Origin origin);

/// A key for programs (`initial-column`), and the reason in words ("its event alone has Initial TRUE").
std::string_view initial_key(model::InitialFrom from);
std::string_view initial_reason(model::InitialFrom from);

/// A key for programs (`task-taken`; empty where it is modelled), and the reason in words.
std::string_view unmodelled_key(model::Unmodelled reason);
std::string_view unmodelled_reason(model::Unmodelled reason);

/// The tasks of a symbol: `O_P2`, `I_P1`.
std::string operation_text(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t operation);
std::string event_text(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t event);

/// What was inferred for a unit beyond its initial state, a sentence each.
std::vector<std::string_view> inferences(const model::Unit& unit);

/// All that l_enter or l_leave of a state switches: events of the unit by place, on or off, in their order.
std::vector<std::pair<std::uint32_t, bool>> switched(const model::Unit& unit, std::uint32_t state, bool entering);

/// "never COND", or "after COND, expect COND within 5 s".
std::string requirement_text(const model::Requirement& requirement, const model::PlantModel& plant);

/// The numeric or BOOL value at the start, as the list's Initial has it, in words.
std::string initial_value_text(const model::Symbol& symbol);

/// The ways back to rest of a `spring` unit that its transitions do not tell, each with what it takes: that of the
/// first commanded one, else the default travel time.
std::vector<model::Transition> spring_returns(const model::Unit& unit);

/// What moves a transition from one state to another, in its parts; empty where it has none.
struct TransitionText {
  std::string on;     ///< `O_P2`; of an automatic one "by itself", of a spring's own way "spring"
  std::string when;   ///< the condition
  std::string after;  ///< "after 5 s"
  std::string takes;  ///< "takes 2 s"; empty for an automatic one that takes no time
};
TransitionText transition_text(const model::Transition& transition, const model::Unit& unit,
                               const model::PlantModel& plant);

}  // namespace symplant::view
