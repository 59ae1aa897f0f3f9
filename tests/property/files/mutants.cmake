# Planted bugs of the reader of plant.json and of the scenario player, one line each. The property test from files must
# find every one of them within CI's plants.
#
# symplant_files_mutant(NAME FOLDER INCLUDE FROM TO): the line FROM of FOLDER becomes TO.
function(symplant_files_mutant NAME FOLDER INCLUDE FROM TO)
  symplant_planted_source(${NAME} ${PROJECT_SOURCE_DIR}/${FOLDER} ${INCLUDE} "${FROM}" "${TO}")
  get_filename_component(floor ${FOLDER} NAME)
  set_target_properties(symplant_${floor} PROPERTIES UNITY_BUILD OFF) # one object is replaced, not all
  add_executable(property_files_mutant_${NAME} main_files.cpp ${source})
  target_include_directories(property_files_mutant_${NAME} BEFORE PRIVATE ${include})
  target_link_libraries(property_files_mutant_${NAME} PRIVATE symplant_property_files symplant_options)
  add_test(NAME property.files.mutant.${NAME} COMMAND property_files_mutant_${NAME} --wrong --quiet --plants 500)
  set_tests_properties(property.files.mutant.${NAME} PROPERTIES TIMEOUT 600 LABELS mutants)
endfunction()

symplant_files_mutant(less_specific_pattern_wins generator/model model
  "return a.literals > b.literals;"
  "return a.literals < b.literals;")

symplant_files_mutant(pattern_beats_exact_name generator/model model
  "      if (exact != nullptr && exact->gives(key)) {"
  "      if (exact != nullptr && exact->gives(key) && best_of(unit, patterns, key) == nullptr) {")

symplant_files_mutant(array_of_a_pattern_stays_where_it_is_empty generator/description description
  "  if (given[static_cast<std::size_t>(key)]) return true;"
  "")

# Of names in braces.
symplant_files_mutant(share_of_an_earlier_try_is_kept generator/text text
  "shares.resize(count); }"
  "shares.resize(count + 1); }")

symplant_files_mutant(process_in_braces_is_the_device generator/model model
  "    if (name == \"process\") return level(process_);"
  "    if (name == \"process\") return level(device_);")

symplant_files_mutant(requirement_for_the_first_match_only generator/model model
  "      add_requirement(index, &matched, unit.device_path(), here);"
  "      add_requirement(index, &matched, unit.device_path(), here); break;")

symplant_files_mutant(transition_of_a_pattern_is_never_left_out generator/model model
  "    if (lacking) unit.left_out.push_back(i);"
  "")

# Of values and of scenarios.
symplant_files_mutant(random_times_of_one_kind generator/description description
  "  if (mean && sigma) return Duration{Duration::Kind::normal, *mean, *sigma};"
  "  if (mean && sigma) return Duration{Duration::Kind::uniform, *mean, *mean + *sigma};")

symplant_files_mutant(once_is_not_read generator/description description
  "    given.once = flag_member(value, \"once\");"
  "")

symplant_files_mutant(last_instant_of_a_wait_not_looked_at runtime/scenario symplant/scenario
  "  if (!waiting_ || met_ || instant.time > deadline_) return;"
  "  if (!waiting_ || met_ || instant.time >= deadline_) return;")

symplant_files_mutant(past_at_counts_from_its_own_time runtime/scenario symplant/scenario
  "  return step.when == Step::When::at ? std::max(step.time, moment_) : moment_ + step.time;"
  "  return step.when == Step::When::at ? step.time : moment_ + step.time;")

symplant_files_mutant(plus_counts_from_the_start_of_a_wait runtime/scenario symplant/scenario
  "met_ ? met_time_ : deadline_);"
  "met_ ? met_time_ : moment_);")

symplant_files_mutant(release_before_force runtime/scenario symplant/scenario
  "    plant_.release(symbol);"
  "    bool forced = false; for (const SymbolValue& value : step.force) forced = forced || value.symbol == symbol; if (!forced) plant_.release(symbol);")

symplant_files_mutant(cycle_without_its_wrap generator/model model
  "return ranks_[to] == (ranks_[from] + 1) % numbers_;"
  "return ranks_[to] == ranks_[from] + 1;")

# Of material flow.
symplant_files_mutant(take_before_put runtime/scenario symplant/scenario
  "  const bool well = act_by_hand(step);"
  "  Step rest = step; bool well = true; if (!step.put.empty()) { rest.take.clear(); for (const auto& from : step.take) well = plant_.take(from) && well; } well = act_by_hand(rest) && well;")

symplant_files_mutant(step_without_room_holds runtime/scenario symplant/scenario
  "  const auto failed = [&](std::uint64_t which) {"
  "  const auto failed = [&](std::uint64_t which) { if (!step.expect) return;")

symplant_files_mutant(inverted_of_a_sensor_not_read generator/description description
  "      sensor.inverted = flag_member(one, \"inverted\");"
  "")

symplant_files_mutant(until_is_the_length_of_a_drive generator/description description
  "         [&](const Json& drive, const Pointer& at) { track.drives.push_back(this->drive(drive, at)); });"
  "         [&](const Json& drive, const Pointer& at) { GivenDrive it = this->drive(drive, at); if (it.until && !track.drives.empty()) *it.until += *track.drives.back().until; track.drives.push_back(it); });")

symplant_files_mutant(ends_in_reverse_order generator/description description
  "      track.ends.push_back({text_or_empty(one, \"to\"), text_or_empty(one, \"when\")});"
  "      track.ends.insert(track.ends.begin(), {text_or_empty(one, \"to\"), text_or_empty(one, \"when\")});")

symplant_files_mutant(braces_in_the_end_of_a_track_stay generator/model model
  "    edit(track.ends[i].to, here / \"end\" / i / \"to\");"
  "")
