// What a device is doing: one of a few activities that exclude each other.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// The first that applies: frozen, blocked, disabled, stopped, moving; else what it does at rest.
enum class Activity : std::uint8_t {
  moving,
  blocked,    ///< an operation commands another state, and it does not move
  waiting,    ///< at rest without a command
  commanded,  ///< at rest in the state that an operation commands
  rest,       ///< at rest; no operation moves it
  disabled,
  stopped,  ///< stopped midway, without a command
  frozen,   ///< in an instantaneous loop
};
inline constexpr std::size_t kActivities = 8;
/// Their names in JSON and tables, as Activity counts.
inline constexpr std::array<std::string_view, kActivities> kActivityNames{"moving", "blocked",  "waiting", "commanded",
                                                                          "rest",   "disabled", "stopped", "frozen"};

/// Whether the time of a move runs.
constexpr bool runs(const plant::UnitView& view) noexcept {
  return view.moving && !view.stopped_midway && !view.disabled && !view.frozen;
}

/// Whether an operation is on that leads elsewhere, and the unit does not move. O(symbols of the unit).
bool is_blocked(const PlantNames& names, const History& history, std::uint32_t unit);

/// What a unit does according to the history. O(symbols of the unit).
Activity activity_of(const PlantNames& names, const History& history, std::uint32_t unit);

}  // namespace symplant::trace
