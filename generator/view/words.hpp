// Texts about the parts of a model, the same in every view.
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

/// The reason for an initial state: a key for programs (`initial-column`), and a text ("its event alone has Initial
/// TRUE").
std::string_view initial_key(model::InitialFrom from);
std::string_view initial_reason(model::InitialFrom from);

/// Why a symbol is in no device: a key for programs (`task-taken`; empty if it is in a device), and a text.
std::string_view unmodelled_key(model::Account reason);
std::string_view unmodelled_reason(model::Account reason);

/// The tasks of a symbol: `O_P2`, `I_P1`.
std::string operation_text(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t operation);
std::string event_text(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t event);

/// What was inferred for a unit beyond its initial state, a sentence each.
std::vector<std::string_view> inferences(const model::Unit& unit);

/// All events that l_enter or l_leave of a state switches, in order: index in the unit, on or off.
std::vector<std::pair<std::uint32_t, bool>> switched(const model::Unit& unit, std::uint32_t state, bool entering);

/// A value, numeric or BOOL, as in the column Initial of a list.
std::string value_text(tables::DataType type, std::uint64_t value);

/// The spring returns of a `spring` unit that its transitions do not contain. Their travel time is that of the first
/// commanded transition, else the default travel time.
std::vector<model::Transition> spring_returns(const model::Unit& unit);

/// The parts of a transition's text; a part is empty if the transition lacks it.
struct TransitionText {
  std::string on;       ///< `O_P2`; "by itself" for an automatic transition, "spring" for a spring return
  std::string when;     ///< the condition
  std::string after;    ///< "after 5 s"
  std::string takes;    ///< "takes 2 s"; empty for an automatic transition that takes no time
  std::string during;   ///< the condition of `while`
  std::string numbers;  ///< "weight 95"
};
TransitionText transition_text(const model::Transition& transition, const model::Unit& unit,
                               const model::PlantModel& plant);

}  // namespace symplant::view
