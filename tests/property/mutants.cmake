# Planted bugs of the engine, one line each. The property test must find every one of them within 6,000
# plants; it ends at the first one that shows it.
#
# symplant_planted_source(NAME FOLDER INCLUDE FROM TO): a source in which the line FROM of a file of FOLDER, included as
# INCLUDE/..., is TO. Its path is then in `source`, the folder to include first in `include`.
function(symplant_planted_source NAME FOLDER INCLUDE FROM TO)
  set(include ${CMAKE_CURRENT_BINARY_DIR}/mutants/${NAME})
  set(source ${include}/mutant.cpp)
  set(script ${PROJECT_SOURCE_DIR}/tests/property/plant_once.cmake)
  file(GLOB_RECURSE originals CONFIGURE_DEPENDS ${FOLDER}/*.hpp ${FOLDER}/*.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DFROM_FOLDER=${FOLDER} -DTO_FOLDER=${include}/${INCLUDE} -DINCLUDE=${INCLUDE}
            -DSOURCE=${source} "-DFROM=${FROM}" "-DTO=${TO}" -P ${script}
    DEPENDS ${originals} ${script}
    VERBATIM)
  set(include ${include} PARENT_SCOPE)
  set(source ${source} PARENT_SCOPE)
endfunction()

# symplant_mutant(NAME FROM TO): the line FROM of runtime/engine becomes TO, and the file that contains it replaces that
# of the engine.
function(symplant_mutant NAME FROM TO)
  symplant_planted_source(${NAME} ${PROJECT_SOURCE_DIR}/runtime/engine symplant/engine "${FROM}" "${TO}")
  set_target_properties(symplant_engine PROPERTIES UNITY_BUILD OFF) # one object is replaced, not all
  add_executable(property_mutant_${NAME} $<TARGET_OBJECTS:property_main> ${source})
  target_include_directories(property_mutant_${NAME} BEFORE PRIVATE ${include})
  target_link_libraries(property_mutant_${NAME} PRIVATE symplant_property symplant_options)
  add_test(NAME property.mutant.${NAME} COMMAND property_mutant_${NAME} --wrong --quiet --plants 6000)
  set_tests_properties(property.mutant.${NAME} PROPERTIES TIMEOUT 600 LABELS mutants)
endfunction()

symplant_mutant(armed_not_restored_while_disabled
  "    disarmed_[word] &= now;"
  "  for (std::uint64_t off = disarmed_[word] & ~now; off != 0; off &= off - 1) { if ((units_[index_.unit_of_operation[word * 64 + static_cast<std::uint32_t>(std::countr_zero(off))]].flags & kDisabled) == 0) disarmed_[word] &= ~(off & (~off + 1)); }")

symplant_mutant(after_not_restarted_by_a_break
  "        record.holds = 0;"
  "")

symplant_mutant(after_remembered_from_an_earlier_visit
  "  if (!held || record.holds == 0) {"
  "  if ((!held && false) || record.holds == 0) {")

symplant_mutant(break_counted_while_disabled
  "  if ((state.flags & kHalted) != 0) return;"
  "  if ((state.flags & kHalted) != 0) { if ((state.flags & kFrozen) == 0) state.holding = 0; return; }")

symplant_mutant(step_reads_this_round
  "    any = any || active_;"
  "    any = any || active_; if (unpublished_) publish();")

symplant_mutant(automatic_not_before_commanded
  "  if (ready.automatic != kNoTransition) {"
  "  if (ready.automatic != kNoTransition && ready.first == kNoTransition) {")

symplant_mutant(own_state_not_wanted
  "  const bool stay_wanted = (on & type.at[here].leads & ~ready.served) != 0 || further == here;"
  "  const bool stay_wanted = further == here;")

symplant_mutant(rounding_up_in_turning_round
  "static_cast<Wide>(travelled) / static_cast<Wide>(forth));"
  "static_cast<Wide>(travelled) / static_cast<Wide>(forth) + (static_cast<Wide>(back) * static_cast<Wide>(travelled) % static_cast<Wide>(forth) != 0 ? 1 : 0));")

symplant_mutant(once_does_not_disarm
  "      if (fired.once && type.actuation == tables::Actuation::latched) disarmed_[word] |= on;"
  "")

symplant_mutant(draw_counter_shared_by_transitions
  "  Record& record = records_[general_row(unit).first_record + type.record_of[transition]];"
  "  Record& record = records_[general_row(unit).first_record + 0 * type.record_of[transition]];")

symplant_mutant(stopped_unit_still_disables
  "      state.flags |= kDisabled;"
  "      state.flags |= kDisabled; if ((state.flags & kMoving) != 0) { general_states_[position].position = state.state; for (const tables::DisableRow& d : tables_.disables) { if (d.by != unit || d.state != state.state) continue; ++general_states_[index_.general.position_of(d.unit)].disabled_by; if ((units_[d.unit].flags & kHalted) == 0) halt_times(d.unit); units_[d.unit].flags |= kDisabled; touch(d.unit); } }")

symplant_mutant(no_round_after_enabling
  "      resume_times(unit);"
  "      resume_times(unit); continue;")

symplant_mutant(watch_expires_one_instant_late
  "  if (!met && head_->now < monitor.deadline) return false;"
  "  if (!met && head_->now <= monitor.deadline) return false;")

# Of the fast path (engine_fast.cpp) and of what it needs.
symplant_mutant(fast_departure_with_several_operations
  "  if ((state.flags & kNotFast) != 0 || (on & (on - 1)) != 0) [[unlikely]]"
  "  if ((state.flags & kNotFast) != 0) [[unlikely]]")

symplant_mutant(fast_departure_switches_watched_events
  "  if (departure.to == tables::kNoState || (type.events != 0 && events_are_seen(row.event_bit / 64))) return false;"
  "  if (departure.to == tables::kNoState) return false;")

symplant_mutant(fast_arrival_without_a_second_round
  "  if ((on & (on - 1)) != 0 || type.at[here].departure(on).to != here) [[unlikely]]"
  "  if ((on & (on - 1)) != 0) [[unlikely]]")

symplant_mutant(fast_arrival_not_reported
  "    touched_.add(entry);"
  "    (void)entry;")

symplant_mutant(fast_close_forgets_findings
  "  if (observer_ != nullptr || (changed & ~operation_words_[word].served) != 0) return false;"
  "  if (observer_ != nullptr) return false;")

symplant_mutant(fast_instant_without_short_events
  "  return observer_ == nullptr && head_->cycle == 0 &&"
  "  return observer_ == nullptr &&")

symplant_mutant(due_time_put_into_a_stale_bucket
  "  inserted_ = -1;  // what follows may change its bucket"
  "")

symplant_mutant(bucket_with_several_due_times_handed_over
  "    if (!is_mixed(bucket)) {"
  "    if (bucket != 0) {")

symplant_mutant(spring_returns_by_any_transition
  "returns ? transition.to == row.rest :"
  "returns ? true :")

# Of inverted symbols, `while`, `weight`, overruns and symbols that follow a condition.
symplant_mutant(force_of_an_inverted_symbol_is_a_level
  "      const bool on = (value != 0) != has_bit(operation ? index_.inverted_operations : index_.inverted_events, bit);"
  "      const bool on = value != 0;")

symplant_mutant(move_without_a_command_has_no_while
  "  if (n == kNoTransition) n = transition_without_command(type, state.state, state.target);"
  "")

symplant_mutant(weight_of_a_transition_that_is_not_ready
  "    return record.holds != 0 && record.ready <= now_ ? weight : 0;"
  "    return record.holds != 0 ? weight : 0;")

symplant_mutant(overrun_counts_on_in_another_state
  "  const std::uint64_t kept = overrun.state == state.state ? overrun.commands & commands : 0;"
  "  const std::uint64_t kept = overrun.commands & commands;")

symplant_mutant(frozen_symbol_still_follows
  "    if (state.frozen != 0 || on == ((events_.made(bit / 64) & mask) != 0)) return;"
  "    if (on == ((events_.made(bit / 64) & mask) != 0)) return;")

symplant_mutant(touch_computed_once_too_few
  "  if (closing > 0 && distance > 0) p.speed_due"
  "  if (closing > 0 && distance > 0 && p.v > 0) p.speed_due")

symplant_mutant(permission_of_a_transfer_not_used_up
  "  state.permission = 0;"
  "")

symplant_mutant(room_that_counts_the_moving_part
  "  const std::uint32_t except = stays ? moving.index : tables::kNone;"
  "  const std::uint32_t except = tables::kNone;")

symplant_mutant(sensor_covered_one_ns_late
  "    if (next < row.mark_count) due_in(time_to_reach(row.marks[next].at - front, p.v));"
  "    if (next < row.mark_count) due_in(time_to_reach(row.marks[next].at - front, p.v) + 1);")

symplant_mutant(backward_mover_not_put_exactly
  "    Position to = std::max(x, p.aim);"
  "    Position to = x;")

symplant_mutant(time_of_a_source_drawn_twice
  "source_names_[source], 0, state.draws++);"
  "source_names_[source], 0, state.draws += 2);")

symplant_mutant(kind_of_a_source_by_its_number
  "% kinds.count)];"
  "% (kinds.count > 1 ? kinds.count - 1 : 1))];")

symplant_mutant(stop_catches_a_part_that_passes
  "      if (x >= row.length || stop_holds_at(track, x)) w = 0;"
  "      if (x >= row.length || stop_holds_at(track, x) || stop_holds_at(track, (x / kMicrometer) * kMicrometer)) w = 0;")

symplant_mutant(end_without_a_drive
  "  if (x < end || drive_speed(track, p, x) <= 0 || stop_holds_at(track, end)) return;"
  "  if (x < end || stop_holds_at(track, end)) return;")

symplant_mutant(speeds_of_backward_movers_in_no_pass
  "      if (i + 1 < state.size && parts[i + 1].at(time) >= tail - row.gap) {"
  "      if (i + 1 < state.size && parts[i + 1].at(time) > tail - row.gap) {")

symplant_mutant(facing_drives_do_not_stop
  "speed_of_drive(drive - 1) > 0 ? 0 : speed;"
  "speed_of_drive(drive - 1) > 0 ? speed : speed;")

symplant_mutant(work_changes_the_first_part_only
  "    work_on(location, i, row);"
  "    if (!any) work_on(location, i, row);")
