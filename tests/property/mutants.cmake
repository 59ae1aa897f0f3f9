# Planted bugs of the engine, one line each. The property test must find every one of them within 6,000
# plants; it ends at the first one that shows it.
include(planted_bugs.cmake)

symplant_planted_bug(engine armed_not_restored_while_disabled
  "    disarmed_[word] &= now;"
  "    if (!BUG) { disarmed_[word] &= now; } else { for (std::uint64_t off = disarmed_[word] & ~now; off != 0; off &= off - 1) { if ((units_[index_.unit_of_operation[word * 64 + static_cast<std::uint32_t>(std::countr_zero(off))]].flags & kDisabled) == 0) disarmed_[word] &= ~(off & (~off + 1)); } }")

symplant_planted_bug(engine after_not_restarted_by_a_break
  "        record.holds = 0;"
  "        if (!BUG) record.holds = 0;")

symplant_planted_bug(engine after_remembered_from_an_earlier_visit
  "  if (!held || record.holds == 0) {"
  "  if ((!held && !BUG) || record.holds == 0) {")

symplant_planted_bug(engine break_counted_while_disabled
  "  if ((state.flags & kHalted) != 0) return;"
  "  if ((state.flags & kHalted) != 0) { if (BUG && (state.flags & kFrozen) == 0) state.holding = 0; return; }")

symplant_planted_bug(engine step_reads_this_round
  "    any = any || active_;"
  "    any = any || active_; if (BUG && unpublished_) publish();")

symplant_planted_bug(engine automatic_not_before_commanded
  "  if (ready.automatic != kNoTransition) {"
  "  if (ready.automatic != kNoTransition && (!BUG || ready.first == kNoTransition)) {")

symplant_planted_bug(engine own_state_not_wanted
  "  const bool stay_wanted = (on & type.at[here].leads & ~ready.served) != 0 || further == here;"
  "  const bool stay_wanted = (!BUG && (on & type.at[here].leads & ~ready.served) != 0) || further == here;")

symplant_planted_bug(engine rounding_up_in_turning_round
  "static_cast<Wide>(travelled) / static_cast<Wide>(forth));"
  "static_cast<Wide>(travelled) / static_cast<Wide>(forth) + (BUG && static_cast<Wide>(back) * static_cast<Wide>(travelled) % static_cast<Wide>(forth) != 0 ? 1 : 0));")

symplant_planted_bug(engine once_does_not_disarm
  "      if (fired.once && type.actuation == tables::Actuation::latched) disarmed_[word] |= on;"
  "      if (!BUG && fired.once && type.actuation == tables::Actuation::latched) disarmed_[word] |= on;")

symplant_planted_bug(engine draw_counter_shared_by_transitions
  "  Record& record = records_[general_row(unit).first_record + type.record_of[transition]];"
  "  Record& record = records_[general_row(unit).first_record + (BUG ? 0 : type.record_of[transition])];")

symplant_planted_bug(engine stopped_unit_still_disables
  "      this->disable(unit);"
  "      this->disable(unit); if (BUG && (state.flags & kMoving) != 0) { general_states_[position].position = state.state; for (const tables::DisableRow& d : tables_.disables) { if (d.by != unit || d.state != state.state) continue; ++general_states_[index_.general.position_of(d.unit)].disabled_by; if ((units_[d.unit].flags & kHalted) == 0) halt_times(d.unit); units_[d.unit].flags |= kDisabled; touch(d.unit); } }")

symplant_planted_bug(engine no_round_after_enabling
  "      suspects_ |= suspect(tables::FindingKind::started_on_enabling);"
  "      suspects_ |= suspect(tables::FindingKind::started_on_enabling); if (BUG) continue;")

symplant_planted_bug(engine watch_expires_one_instant_late
  "  if (!met && head_->now < later(monitor.started, row.within)) return false;"
  "  if (!met && head_->now - (BUG ? 1 : 0) < later(monitor.started, row.within)) return false;")

symplant_planted_bug(engine watch_is_met_too_early
  "  return !met || head_->now < later(monitor.started, row.earliest);"
  "  return !met || (!BUG && head_->now < later(monitor.started, row.earliest));")

# Of the fast path (engine_fast.cpp) and of what it needs.
symplant_planted_bug(engine fast_departure_with_several_operations
  "  if ((state.flags & kNotFast) != 0 || (on & (on - 1)) != 0) [[unlikely]]"
  "  if ((state.flags & kNotFast) != 0 || (!BUG && (on & (on - 1)) != 0)) [[unlikely]]")

symplant_planted_bug(engine fast_departure_switches_watched_events
  "  if (departure.to == tables::kNoState || (type.events != 0 && events_are_seen(row.event_bit / 64))) return false;"
  "  if (departure.to == tables::kNoState || (!BUG && type.events != 0 && events_are_seen(row.event_bit / 64))) return false;")

symplant_planted_bug(engine fast_arrival_without_a_second_round
  "  if ((on & (on - 1)) != 0 || type.at[here].departure(on).to != here) [[unlikely]]"
  "  if ((on & (on - 1)) != 0 || (!BUG && type.at[here].departure(on).to != here)) [[unlikely]]")

symplant_planted_bug(engine fast_arrival_not_reported
  "    touched_.add(entry);"
  "    if (!BUG) touched_.add(entry);")

symplant_planted_bug(engine fast_close_forgets_findings
  "  if (observer_ != nullptr || (changed & ~operation_words_[word].served) != 0) return false;"
  "  if (observer_ != nullptr || (!BUG && (changed & ~operation_words_[word].served) != 0)) return false;")

symplant_planted_bug(engine fast_instant_without_short_events
  "  return observer_ == nullptr && head_->cycle == 0 &&"
  "  return observer_ == nullptr && (BUG || head_->cycle == 0) &&")

symplant_planted_bug(engine due_time_put_into_a_stale_bucket
  "  inserted_ = -1;  // what follows may change its bucket"
  "  if (!BUG) inserted_ = -1;  // what follows may change its bucket")

symplant_planted_bug(engine bucket_with_several_due_times_handed_over
  "    if (!is_mixed(bucket)) {"
  "    if (BUG || !is_mixed(bucket)) {")

set(SYMPLANT_FIRST_PLANT_OF_spring_returns_by_any_transition 2890)
symplant_planted_bug(engine spring_returns_by_any_transition
  "returns ? transition.to == row.rest :"
  "returns ? BUG || transition.to == row.rest :")

# Of inverted symbols, `while`, `weight`, overruns and symbols that follow a condition.
symplant_planted_bug(engine force_of_an_inverted_symbol_is_a_level
  "      const bool on = (to.value != 0) != has_bit(operation ? index_.inverted_operations : index_.inverted_events, bit);"
  "      const bool on = (to.value != 0) != (!BUG && has_bit(operation ? index_.inverted_operations : index_.inverted_events, bit));")

symplant_planted_bug(engine move_without_a_command_has_no_while
  "  if (n == kNoTransition) n = transition_without_command(type, state.state, state.target);"
  "  if (!BUG && n == kNoTransition) n = transition_without_command(type, state.state, state.target);")

symplant_planted_bug(engine weight_of_a_transition_that_is_not_ready
  "    return record.holds != 0 && record.ready <= now_ ? weight : 0;"
  "    return record.holds != 0 && (BUG || record.ready <= now_) ? weight : 0;")

symplant_planted_bug(engine overrun_counts_on_in_another_state
  "  const std::uint64_t kept = overrun.state == state.state ? overrun.commands & commands : 0;"
  "  const std::uint64_t kept = BUG || overrun.state == state.state ? overrun.commands & commands : 0;")

symplant_planted_bug(engine frozen_symbol_still_follows
  "    if (state.frozen != 0 || on == was) return;"
  "    if ((!BUG && state.frozen != 0) || on == was) return;")

symplant_planted_bug(engine touch_computed_once_too_few
  "  if (closing > 0 && distance > 0) p.speed_due"
  "  if (closing > 0 && distance > 0 && (!BUG || p.v > 0)) p.speed_due")

symplant_planted_bug(engine permission_of_a_transfer_not_used_up
  "  state.permission = 0;"
  "  if (!BUG) state.permission = 0;")

symplant_planted_bug(engine room_that_counts_the_moving_part
  "  const std::uint32_t except = stays ? moving.index : tables::kNone;"
  "  const std::uint32_t except = stays && !BUG ? moving.index : tables::kNone;")

symplant_planted_bug(engine sensor_covered_one_ns_late
  "    if (next < row.mark_count) due_in(time_to_reach(row.marks[next].at - front, p.v));"
  "    if (next < row.mark_count) due_in(time_to_reach(row.marks[next].at - front, p.v) + (BUG ? 1 : 0));")

symplant_planted_bug(engine backward_mover_not_put_exactly
  "    Position to = std::max(x, p.aim);"
  "    Position to = BUG ? x : std::max(x, p.aim);")

symplant_planted_bug(engine time_of_a_source_drawn_twice
  "source_names_[source], 0, state.draws++);"
  "source_names_[source], 0, BUG ? state.draws += 2 : state.draws++);")

symplant_planted_bug(engine kind_of_a_source_by_its_number
  "% kinds.count)];"
  "% (BUG && kinds.count > 1 ? kinds.count - 1 : kinds.count))];")

symplant_planted_bug(engine stop_catches_a_part_that_passes
  "      if (x >= row.length || stop_holds_at(track, x)) w = 0;"
  "      if (x >= row.length || stop_holds_at(track, x) || (BUG && stop_holds_at(track, (x / kMicrometer) * kMicrometer))) w = 0;")

symplant_planted_bug(engine end_without_a_drive
  "  if (x < end || drive_speed(track, p, x) <= 0 || stop_holds_at(track, end)) return;"
  "  if (x < end || (!BUG && drive_speed(track, p, x) <= 0) || stop_holds_at(track, end)) return;")

symplant_planted_bug(engine speeds_of_backward_movers_in_no_pass
  "      if (i + 1 < state.size && parts[i + 1].at(time) >= tail - row.gap) {"
  "      if (i + 1 < state.size && parts[i + 1].at(time) >= tail - row.gap + (BUG ? 1 : 0)) {")

symplant_planted_bug(engine facing_drives_do_not_stop
  "speed_of_drive(drive - 1) > 0 ? 0 : speed;"
  "speed_of_drive(drive - 1) > 0 && !BUG ? 0 : speed;")

symplant_planted_bug(engine work_changes_the_first_part_only
  "    work_on(location, i, row);"
  "    if (!BUG || !any) work_on(location, i, row);")

# Of parts that lie across two tracks.
symplant_planted_bug(engine tail_leaves_a_sensor_late
  "    return time_to_pass(mark.at - (row.length - left), p.v);"
  "    return time_to_pass(mark.at - (row.length - left), p.v) + (BUG ? 1 : 0);")

symplant_planted_bug(engine tail_takes_no_room
  "         tail_in_the_way(to.location, x, moving) == nullptr;"
  "         (BUG || tail_in_the_way(to.location, x, moving) == nullptr);")

symplant_planted_bug(engine no_room_appears_behind_a_tail
  "    if (left > 0 && p.v > 0) due"
  "    if (!BUG && left > 0 && p.v > 0) due")

symplant_planted_bug(engine tail_of_a_part_that_was_taken_is_seen
  "  sensors_under_tail(track);
  tracks_[track].tail_on = 0;"
  "  if (!BUG) sensors_under_tail(track);
  tracks_[track].tail_on = 0;")

set(SYMPLANT_FIRST_PLANT_OF_tails_read_in_the_order_of_the_ends 880)
symplant_planted_bug(engine tails_read_in_the_order_of_the_ends
  "    if (seen == nullptr || is_further(p, *seen, time)) seen = &p;"
  "    if (seen == nullptr || (!BUG && is_further(p, *seen, time))) seen = &p;")

symplant_planted_bug(engine drive_without_direction_stands
  "  const bool forward = row.always_forward() || (row"
  "  const bool forward = (!BUG && row.always_forward()) || (row")

# Of malfunctions.
symplant_planted_bug(engine slower_changes_a_move_in_progress
  "void Malfunctions::slow(std::uint32_t unit) noexcept { engine_.units_[unit].flags |= kSlowed | kGeneral; }"
  "void Malfunctions::slow(std::uint32_t unit) noexcept { UnitState& state = engine_.units_[unit]; state.flags |= kSlowed | kGeneral; if (BUG && (state.flags & (kMoving | kTimed)) == (kMoving | kTimed)) engine_.set_wheel(unit, later(state.due, state.due - now())); }")

symplant_planted_bug(engine slowed_unit_stays_on_the_fast_path
  "    effect.kind == MalfunctionKind::stuck ? stick(of.unit, of.state) : slow(of.unit);"
  "    effect.kind == MalfunctionKind::stuck ? stick(of.unit, of.state) : slow(of.unit); if (BUG && effect.kind == MalfunctionKind::slower && tables_.units[of.unit].general == 0 && engine_.index_.types[tables_.units[of.unit].type].plain) engine_.units_[of.unit].flags &= static_cast<std::uint16_t>(~kGeneral);")

symplant_planted_bug(engine slower_rounds_too_early
  "  const Wide product = static_cast<Wide>(time) * factor / 1000;"
  "  const Wide product = BUG ? static_cast<Wide>(time) / 1000 * factor : static_cast<Wide>(time) * factor / 1000;")

symplant_planted_bug(engine total_time_of_a_slowed_move_is_the_tables
  "  if ((slowed_[unit / 64] & bit_in_word(unit)) == 0) return time;"
  "  if (BUG || (slowed_[unit / 64] & bit_in_word(unit)) == 0) return time;")

symplant_planted_bug(engine remedied_by_what_held_before_the_start
  "    seen_.mark(number);
  }
  active_[head_->active++]"
  "    seen_.mark(number);
    if (BUG && row(number).unless != tables::kNone && engine_.truth(row(number).unless)) { state.wishes = kEnds; head_->pending = 1; }
  }
  active_[head_->active++]")

symplant_planted_bug(engine time_of_a_flicker_drawn_twice
  "    override_again(effect.subject);
  }"
  "    override_again(effect.subject);
    if (BUG && state.shows == 0) state.due = next_flicker(number, e);
  }")

symplant_planted_bug(engine malfunction_hides_a_force
  "  if (!engine_.is_forced(symbol)) engine_.override_symbol(symbol, override_of(symbol));"
  "  if (BUG || !engine_.is_forced(symbol)) engine_.override_symbol(symbol, override_of(symbol));")

symplant_planted_bug(engine malfunction_that_started_first_wins
  "    if (address_of(other) == address) to = {Override::Kind::value, true, value};"
  "    if (address_of(other) == address && (!BUG || to.kind == Override::Kind::none)) to = {Override::Kind::value, true, value};")

symplant_planted_bug(engine flicker_shows_the_opposite_of_the_model
  "      to.value ^= 1;"
  "      if (BUG) to.kind = Override::Kind::opposite; else to.value ^= 1;")

symplant_planted_bug(engine started_on_enabling_after_a_malfunction
  "  if (!disabled && (engine_.units_[unit].flags & kDisabled) != 0) engine_.enable(unit, 0);"
  "  if (!disabled && (engine_.units_[unit].flags & kDisabled) != 0) { engine_.enable(unit, BUG ? kEnabledNow : 0); if (BUG) engine_.suspects_ |= suspect(tables::FindingKind::started_on_enabling); }")

symplant_planted_bug(engine one_of_two_stuck_malfunctions_ends_both
  "--engine_.general_state(unit).disabled_by != 0 : is_stuck(unit);"
  "--engine_.general_state(unit).disabled_by != 0 : !BUG && is_stuck(unit);")

symplant_planted_bug(engine malfunction_starts_while_its_condition_holds
  "  if (begins && may_start) state.wishes |= kStarts;"
  "  if ((BUG ? holds : begins) && may_start) state.wishes |= kStarts;")

symplant_planted_bug(engine malfunction_that_has_lasted_becomes_another
  "    } else if (state.due <= now()) {
      end(number, By::end);
    } else if (state.becomes <= now()) {
      become(number);"
  "    } else if (state.due <= now() && (!BUG || state.becomes > now())) {
      end(number, By::end);
    } else if (state.becomes <= now()) {
      become(number);")

symplant_planted_bug(engine chance_not_drawn_after_an_end
  "    state.due = after(number, row(number).chance, kChanceStream);
  } else {"
  "    state.due = BUG && by != By::end ? tables::kNever : after(number, row(number).chance, kChanceStream);
  } else {")

symplant_planted_bug(engine event_holds_what_the_model_made
  "  return (bits & bit_in_word(row.index)) != 0 ? 1 : 0;"
  "  return ((BUG ? engine_.events_.made(word) ^ engine_.index_.inverted_events[word] : bits) & bit_in_word(row.index)) != 0 ? 1 : 0;")

symplant_planted_bug(engine all_effects_begin_at_once
  "    states_[number].begun = e + 1;"
  "    states_[number].begun = BUG ? static_cast<std::uint32_t>(effects.size()) : e + 1;")

symplant_planted_bug(engine stopped_while_starts_again_at_once
  "  if (numbers_.is_written(number)) states_[number].waits = row(number).during ? 1 : 0;"
  "  if (numbers_.is_written(number)) states_[number].waits = !BUG && row(number).during ? 1 : 0;")

symplant_planted_bug(engine worn_belt_keeps_its_speed_until_a_command
  "  for (const std::uint32_t track : tables_.malfunctions.tracks_of(effect)) engine_.flow_.drives_changed(track);"
  "  if (!BUG) { for (const std::uint32_t track : tables_.malfunctions.tracks_of(effect)) engine_.flow_.drives_changed(track); }")

# Of malfunctions that start and end without end.
symplant_planted_bug(engine starts_of_an_earlier_millisecond_counted
  "    for (std::uint32_t m = 0; m < written_; ++m) states_[m].counted = 0;"
  "    if (!BUG) { for (std::uint32_t m = 0; m < written_; ++m) states_[m].counted = 0; }")

symplant_planted_bug(engine ten_thousand_starts_and_ends_are_a_loop
  "  if (is_loop()) freeze_loop();"
  "  if (head_->counted > kMostInLoopWindow - (BUG ? 1 : 0)) freeze_loop();")

symplant_planted_bug(engine frozen_malfunction_starts_again
  "  if (numbers_.is_written(number) && states_[number].frozen != 0) return true;"
  "  if (!BUG && numbers_.is_written(number) && states_[number].frozen != 0) return true;")

symplant_planted_bug(engine loop_without_its_inactive_members
  "    if (state.frozen != 0 || state.counted < kLeastOfLoop) continue;"
  "    if (state.frozen != 0 || state.counted < kLeastOfLoop || (BUG && state.active == 0)) continue;")

# Of values and signals; the bugs before are looked for in plants without values, which take a third of the time.
get_property(names DIRECTORY PROPERTY symplant_planted_bugs)
list(LENGTH names SYMPLANT_BUGS_WITHOUT_VALUES)
symplant_planted_bug(engine stored_input_of_the_wrong_step
  "  const double u = stored_[step.formula];"
  "  const double u = BUG && step.kind == ValueKind::integral ? evaluate(step.formula) : stored_[step.formula];")

symplant_planted_bug(engine parameter_forgets_what_was_set_while_it_was_held
  "  if (states_[value].held != 0) *memory(value) = limited(number, row.min, row.max);"
  "  if (!BUG && states_[value].held != 0) *memory(value) = limited(number, row.min, row.max);")

symplant_planted_bug(engine drift_stops_with_its_input
  "    if (row.noise == 0 && index_.timed_signals[signal] == 0 && drifts_[signal] == 0) sleep(rank);"
  "    if (row.noise == 0 && index_.timed_signals[signal] == 0 && (BUG || drifts_[signal] == 0)) sleep(rank);")

symplant_planted_bug(engine switch_is_on_while_both_conditions_hold
  "    const bool on = (truth(row.condition) || stays) && (row.off == tables::kNone || !truth(row.off));"
  "    const bool on = BUG ? truth(row.condition) || (stays && !truth(row.off)) : (truth(row.condition) || stays) && (row.off == tables::kNone || !truth(row.off));")

symplant_planted_bug(engine time_by_a_formula_is_rounded
  "  return static_cast<tables::Time>(std::floor(std::min(result, 1e9) * 1e9));"
  "  return static_cast<tables::Time>((BUG ? std::nearbyint(std::min(result, 1e9) * 1e9) : std::floor(std::min(result, 1e9) * 1e9)));")

symplant_planted_bug(engine lag_factor_by_float
  "x + (u - x) * step.factor);"
  "x + (u - x) * (BUG ? static_cast<double>(static_cast<float>(step.factor)) : step.factor));")

symplant_planted_bug(engine delay_one_step_too_short
  "memory(step.value)[state.oldest]);"
  "memory(step.value)[(state.oldest + (BUG ? 1 : 0)) % tables_->rows[step.value].steps]);")

symplant_planted_bug(engine delay_sleeps_before_its_output_has_changed
  "state.equal < steps || !shown ? kMoved"
  "state.equal < steps || (!BUG && !shown) ? kMoved")

symplant_planted_bug(engine limit_before_the_finite_check
  "  } else if (std::isfinite(result)) {
    result = limited(result, step.min, step.max);"
  "  } else if (std::isfinite(result) || (BUG && step.kind == ValueKind::is && std::isfinite(limited(result, step.min, step.max)))) {
    result = limited(result, step.min, step.max);")

symplant_planted_bug(engine limit_below_zero_is_kept
  "    result += 0.0;  // never -0"
  "    if (!BUG) result += 0.0;")

symplant_planted_bug(engine noise_drawn_twice
  "name, 0, draws++);"
  "name, 0, BUG ? draws += 2 : draws++);")

symplant_planted_bug(engine signal_computed_after_another_was_written
  "    numbers_[signal] = std::isnan(n) ? engine_.event_values_.made[symbol.index] : shown(row, n);"
  "    numbers_[signal] = std::isnan(n) ? engine_.event_values_.made[symbol.index] : shown(row, n);
    if (BUG && !engine_.is_forced(row.symbol)) value_changed(tables::Direction::event, symbol.index, numbers_[signal]);")

symplant_planted_bug(engine signal_that_is_no_number_is_zero
  "std::isnan(n) ? engine_.event_values_.made[symbol.index] : shown(row, n);"
  "std::isnan(n) ? (BUG ? 0 : engine_.event_values_.made[symbol.index]) : shown(row, n);")

symplant_planted_bug(engine signal_rounds_half_away_from_zero
  "  number = limited(std::nearbyint(number), "
  "  number = limited(BUG ? std::round(number) : std::nearbyint(number), ")

symplant_planted_bug(engine second_instant_of_a_time_steps_again
  "  const bool first = head_->instant != now();"
  "  const bool first = BUG || head_->instant != now();")

symplant_planted_bug(engine skipped_instant_computes_later
  "    if (values_.active()) values_.end_time();
    return;"
  "    if (values_.active() && !BUG) values_.end_time();
    return;")

symplant_planted_bug(engine ramp_down_by_up
  "stored_[step.formula + step.formulas - 1];"
  "stored_[step.formula + (BUG ? 1U : step.formulas - 1U)];")

symplant_planted_bug(engine jump_that_loses_an_edge
  "    held_[change] = holds ? 1 : 0;"
  "    if (!BUG || holds) held_[change] = holds ? 1 : 0;")

symplant_planted_bug(engine jump_reads_its_value_as_the_round_began
  "  seen_[row.output] = outputs_[row.output];"
  "  if (!BUG) seen_[row.output] = outputs_[row.output];")

symplant_planted_bug(engine order_of_values_that_read_others
  "  for (const std::uint32_t v : values.order) rank_value(v, computed);"
  "  for (std::size_t i = 0; i < values.order.size(); ++i) rank_value(values.order[BUG ? values.order.size() - 1 - i : i], computed);")

symplant_planted_bug(engine value_that_was_set_makes_its_step
  "  if (state.stored == 0 || state.set_at == now()) return 0;"
  "  if (state.stored == 0 || (!BUG && state.set_at == now())) return 0;")

symplant_planted_bug(engine values_stop_after_a_line_of_the_trace
  "      values_.entry_due();"
  "      if (!BUG || values_.due()) values_.entry_due();")

symplant_planted_bug(engine value_with_a_step_that_fails_sleeps
  "  if (pass == 0 && !step.timed"
  "  if ((pass == 0 || (BUG && pass == kFailed)) && !step.timed")

symplant_planted_bug(engine controller_winds_up
  "row.ti == 0 || winds_up ? integral"
  "row.ti == 0 || (!BUG && winds_up) ? integral")

symplant_planted_bug(engine derivative_from_zero
  "  const double result = state.remembers != 0 ? (u - last) / step.h : 0;"
  "  const double result = BUG || state.remembers != 0 ? (u - last) / step.h : 0;")

symplant_planted_bug(engine sums_of_a_linear_value_from_zero
  "sum = i == 0 ? a[i] * x[i] : sum + a[i] * x[i];
  for (std::uint32_t i = 0; i < inputs; ++i) sum = states"
  "sum = i == 0 ? a[i] * x[i] : sum + a[i] * x[i];
  if (BUG) { double other = 0; for (std::uint32_t i = inputs; i-- > 0;) other += b[i] * u[i]; return sum + other; }
  for (std::uint32_t i = 0; i < inputs; ++i) sum = states")

symplant_planted_layer(engine ${PROJECT_SOURCE_DIR}/runtime/engine)
add_executable(property_mutants $<TARGET_OBJECTS:property_main> $<TARGET_OBJECTS:symplant_engine_planted>)
target_link_libraries(property_mutants PRIVATE symplant_property symplant_options)
symplant_planted_tests(property_mutants property.mutant 6000)
