// What the plant finds while it runs (docs/model.md, "Findings at run time").
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::tables {

/// In the order in which those of one instant stand.
enum class FindingKind : std::uint8_t {
  conflicting_operations,         ///< of a unit
  stopped_under_another_command,  ///< of a unit
  command_to_a_disabled_unit,     ///< of an operation
  command_without_effect,         ///< of an operation
  lost_command,                   ///< of an operation
  started_on_enabling,            ///< of a unit; a note
  event_too_short,                ///< of an event
  instantaneous_loop,             ///< of units: one finding each, `more` set on all but the loop's last
  requirement_violated,           ///< of a requirement
  link_lost,                      ///< of a link; this and the next are the host's, not the model's
  link_back,                      ///< of a link; a note
};
inline constexpr int kFindingKinds = 9;      ///< of the model
inline constexpr int kAllFindingKinds = 11;  ///< with those of the host

struct Finding {
  Time time;
  std::uint32_t of;  ///< a unit, a symbol or a requirement, by its place in the tables; a link by its place in the run
  FindingKind kind;
  bool more;  ///< the next finding names a further unit of this same loop

  friend bool operator==(const Finding&, const Finding&) = default;
};

}  // namespace symplant::tables
