# Planted bugs of the order of scans, samples and losses. The property test must find every one of them.
include(../planted_bugs.cmake)

symplant_planted_bug(program events_one_instant_early
  "    take_events();\n    if (plant_.now() != next || frozen()) return;  // it was set back or stopped from outside\n    if (note_losses()) {\n      advance_plant(next, next >= time);\n      take_events();\n    }\n    scan_due(next);"
  "    if (!BUG) take_events();\n    if (plant_.now() != next || frozen()) return;  // it was set back or stopped from outside\n    if (note_losses()) {\n      advance_plant(next, next >= time);\n      take_events();\n    }\n    scan_due(next);\n    if (BUG) take_events();")

symplant_planted_bug(program outputs_in_the_same_instant
  "  sample_ = now + times_.delay;"
  "  sample_ = now + (BUG ? 0 : times_.delay);")

symplant_planted_bug(program second_program_sees_the_outputs_of_the_first
  "    if (const int code = running.instance->scan(time); code != 0) fail(*running.instance, scan, code);"
  "    if (const int code = running.instance->scan(time); code != 0) fail(*running.instance, scan, code);\n    if (BUG) { running.instance->write_operations(); advance_plant(time, false); take_events(); }")

symplant_planted_bug(program scans_while_the_controller_is_lost
  "    if (running.lost || failure_) continue;"
  "    if ((running.lost && !BUG) || failure_) continue;")

symplant_planted_bug(program a_loss_keeps_what_is_not_yet_sampled
  "  drop();\n  return options_.on_loss"
  "  if (!BUG) drop();\n  return options_.on_loss")

symplant_planted_bug(program dropped_writes_count_as_written
  "  for (const Change& change : changed_) written_[change.write] = change.before;"
  "  for (const Change& change : changed_) { if (!BUG) written_[change.write] = change.before; }")

symplant_planted_bug(program operations_hold_on_a_restart
  "  end();\n  zero();"
  "  end();\n  if (!BUG) zero();")

symplant_planted_bug(program numbers_without_their_sign
  "    plant_.set_operation_value(row.index, link::image::value_of(written_[write], row.type()));"
  "    plant_.set_operation_value(row.index, BUG ? written_[write] : link::image::value_of(written_[write], row.type()));")

symplant_planted_layer(program ${PROJECT_SOURCE_DIR}/runtime/program)
add_executable(property_lock_step_mutants main_lock_step.cpp $<TARGET_OBJECTS:symplant_program_planted>)
target_link_libraries(property_lock_step_mutants PRIVATE symplant_property_lock_step symplant_options)
symplant_planted_tests(property_lock_step_mutants property.lock_step.mutant 2000)
