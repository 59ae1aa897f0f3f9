// Counts how often a run of the reference takes each path of docs/model.md, docs/material.md,
// docs/malfunctions.md and docs/values.md, so that a test of random plants can report it.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace symplant::reference {

/// Every step, cell, event and finding in these pages, in the order of `kCountedNames`.
enum class Counted : std::size_t {
  settle,
  automatic_fired,
  commanded_fired,
  stayed_conflicting,
  stayed_own_state_wanted,
  spring_left_for_rest,
  wanted_transition,
  fired_takes_zero,
  // The table of moving units: commanded moves of enabled units, once per round.
  latched_forth,
  latched_both,
  latched_back,
  latched_neither,
  bistable_forth,
  bistable_both,
  bistable_back,
  bistable_neither,
  held_forth,
  held_both,
  held_back,
  held_neither,
  spring_forth,
  spring_both,
  spring_back,
  spring_neither_from_rest,
  spring_neither_from_elsewhere,
  automatic_move_goes_on,
  turned_round,
  stood_still,  ///< stopped while moving
  went_on,      ///< continued after stopping
  disarmed_automatic,
  disarmed_once,
  rearmed,
  rearmed_while_disabled,
  after_broken,
  after_kept_while_disabled,
  unit_disabled,
  unit_enabled,
  found_conflicting_operations,
  found_stopped_under_another_command,
  found_command_to_a_disabled_unit,
  found_command_without_effect,
  found_overrun,
  found_lost_command,
  found_started_on_enabling,
  found_event_too_short,
  found_event_too_short_real_time,
  found_instantaneous_loop,
  found_requirement_violated,
  loop_frozen,
  rounds_doubled,
  draw_uniform,
  draw_normal,
  draw_after,
  draw_takes,
  draw_behaviour,
  forced_event_differs,  ///< a round switched an event that a force hides
  set_state_moving,
  set_state_disabled,
  set_state_frozen,
  watch_started,
  watch_met,
  watch_met_early,
  watch_violated,
  never_violated,
  woken,
  started,
  restored,
  inverted_operation_rose,
  inverted_operation_fell,
  inverted_event_switched,
  inverted_forced,
  inverted_input,
  while_stopped,
  while_resumed,
  while_stopped_automatic,
  while_stopped_latched,
  while_stopped_without_command,
  while_stopped_on_return,
  weight_of_one,
  weight_of_several,
  overrun_ended,
  overrun_broken_by_disabling,
  follow_switched,
  follow_chain,
  follow_frozen,
  follow_on_a_shared_address,
  // Parts.
  part_touched,
  part_touched_backward,
  queue_released,
  drive_entered,
  facing_stopped,
  stop_caught,
  stop_caught_backward,
  moved_backward,
  overshot,
  end_with_room,
  end_out,
  end_waited,
  transfer_moved,
  transfer_waited,
  once_used,
  work_changed,
  source_made,
  source_waited,
  source_draw,
  sensor_switched,
  sensor_number_changed,
  kind_filtered,
  put_by_hand,
  put_refused,
  taken_by_hand,
  take_refused,
  transfer_frozen,
  work_frozen,
  track_frozen,
  found_part_blocked,
  moved_without_direction,
  tail_began,
  tail_seen,
  tail_left_a_sensor,
  tail_in_the_way,
  tail_moved_away,
  tail_got_further,
  // Malfunctions.
  started_by_scenario,
  started_by_hand,
  started_by_condition,
  started_by_chance,
  started_by_becoming,
  started_while_active,
  started_once_at_a_time,  ///< not again by its condition
  start_refused,
  ordinary_started,
  lose_started,
  stopped_by_hand,
  remedied,
  lasted,
  further_instant,
  malfunction_frozen,
  frozen_malfunction_started,
  slow_by_written,
  slow_by_ordinary,
  slow_by_several,
  slower_takes_nothing,
  slower_starts_during_a_move,
  stuck_settled,
  stuck_moving,
  stuck_disabled,
  stuck_in_a_state,
  stuck_ended_moving,
  stuck_ended_disabled,
  force_hides_malfunction,
  operation_broken,
  number_broken,
  inverted_broken,
  flickered,
  flickered_below_a_force,
  flickered_above_another,
  while_started,  ///< a malfunction
  while_ended,
  while_waits,  ///< it was stopped from outside
  several_effects_started,
  held,  ///< an event with what it showed
  track_broken,
  parameter_held,
  held_parameter_set,
  held_parameter_jumped,
  distorted,         ///< a `distort` began
  signal_distorted,  ///< it was computed
  hysteresis_both,
  hysteresis_stayed,  ///< on between the two conditions
  time_computed,      ///< by a formula
  // Values.
  integral_stepped,
  lag_stepped,
  ramp_stepped,
  delay_stepped,
  linear_stepped,
  derivative_computed,
  is_computed,
  position_computed,  ///< between two states
  noise_computed,
  pid_computed,
  outputs_computed,  ///< of a `linear` value with `d`
  step_not_finite,
  ramp_rose,
  ramp_fell,
  value_limited,
  value_stepped,
  value_set,
  value_set_before_its_step,
  value_without_stored_input,
  value_jumped,
  value_jumped_twice,  ///< in one round
  jump_not_finite,
  value_frozen,
  pid_wound_up,
  signal_changed,
  signal_kept,
  found_value_not_finite,
  value_finite_again,
  number_of,
};
inline constexpr std::size_t kCounted = static_cast<std::size_t>(Counted::number_of);

/// In the order of Counted.
extern const std::array<std::string_view, kCounted> kCountedNames;

struct Counters {
  std::array<long, kCounted> counts{};

  long& operator[](Counted what) { return counts[static_cast<std::size_t>(what)]; }
  long operator[](Counted what) const { return counts[static_cast<std::size_t>(what)]; }
  Counters& operator+=(const Counters& other) {
    for (std::size_t i = 0; i < kCounted; ++i) counts[i] += other.counts[i];
    return *this;
  }
};

}  // namespace symplant::reference
