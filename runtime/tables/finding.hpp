// Findings at run time (docs/model.md, "What the plant finds").
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::tables {

/// The enumerators are in the order in which findings of one instant are reported.
enum class FindingKind : std::uint8_t {
  conflicting_operations,         ///< of a unit
  stopped_under_another_command,  ///< of a unit
  command_to_a_disabled_unit,     ///< of an operation
  command_without_effect,         ///< of an operation
  overrun,                        ///< of a unit
  lost_command,                   ///< of an operation
  started_on_enabling,            ///< of a unit; a note
  event_too_short,                ///< of an event
  /// Of units, follows and material, or of malfunctions: one finding each, `more` set on all but the loop's last.
  instantaneous_loop,
  requirement_violated,  ///< of a requirement
  part_blocked,          ///< of a transfer of parts
  value_not_finite,      ///< of a value
  link_lost,             ///< of a link; the host reports this kind and the next ones, the model the others
  link_back,             ///< of a link; a note
  event_overwritten,     ///< of an event
  clock_restarted,       ///< of the operation that is the PLC's clock
  standstill,            ///< of the plant: `of` is the time in ms that it lost
  no_plc,                ///< of a link: no PLC has exchanged anything
  request_refused,       ///< of a link: an exception answered a request, or the PLC refused one
  not_read,              ///< of an event: it came and went between two reads of it
  not_sampled,           ///< of an operation: it came and went between two cycles
  several_writers,       ///< of an operation: two clients wrote different values within a cycle
  symbol_left_out,       ///< of a symbol: the PLC permanently refuses its address, so its link leaves it out
};
inline constexpr int kFindingKinds = 12;     ///< kinds that the model reports
inline constexpr int kAllFindingKinds = 23;  ///< with the kinds that the host reports

struct Finding {
  Time time;
  /// Index of a unit, symbol, requirement, transfer or value in the tables, or of a link in the run. In an
  /// instantaneous loop the units are followed by the rows of PlantTables::follows, then by tracks, transfers, work,
  /// sources and written malfunctions, then values.
  std::uint32_t of;
  FindingKind kind;
  bool more;  ///< the next finding names another member of the same loop

  friend bool operator==(const Finding&, const Finding&) = default;
};

}  // namespace symplant::tables
