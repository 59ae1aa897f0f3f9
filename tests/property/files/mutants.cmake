# Planted bugs of the reader of plant.json and of the scenario player, one line each. The property test from files must
# find every one of them within CI's plants.
include(../planted_bugs.cmake)

symplant_planted_bug(model less_specific_pattern_wins
  "return a.literals > b.literals;"
  "return BUG ? a.literals < b.literals : a.literals > b.literals;")

symplant_planted_bug(model pattern_beats_exact_name
  "      if (exact != nullptr && exact->gives(key)) {"
  "      if (exact != nullptr && exact->gives(key) && (!BUG || best_of(unit, patterns, key) == nullptr)) {")

symplant_planted_bug(description array_of_a_pattern_stays_where_it_is_empty
  "  if (given[static_cast<std::size_t>(key)]) return true;"
  "  if (!BUG && given[static_cast<std::size_t>(key)]) return true;")

# Of names in braces.
symplant_planted_bug(text share_of_an_earlier_try_is_kept
  "shares.resize(count); }"
  "shares.resize(count + (BUG ? 1 : 0)); }")

symplant_planted_bug(model process_in_braces_is_the_device
  "    if (name == \"process\") return level(process_);"
  "    if (name == \"process\") return level(BUG ? device_ : process_);")

symplant_planted_bug(model requirement_for_the_first_match_only
  "      add_requirement(index, &matched, unit.device_path(), here);"
  "      if (!BUG || plant_.requirements.empty() || plant_.requirements.back().given != index) add_requirement(index, &matched, unit.device_path(), here);")

symplant_planted_bug(model transition_of_a_pattern_is_never_left_out
  "    if (lacking) unit.left_out.push_back(i);"
  "    if (!BUG && lacking) unit.left_out.push_back(i);")

# Of values and of scenarios.
symplant_planted_bug(description random_times_of_one_kind
  "  if (mean && sigma) return Duration{Duration::Kind::normal, *mean, *sigma};"
  "  if (mean && sigma) return BUG ? Duration{Duration::Kind::uniform, *mean, *mean + *sigma} : Duration{Duration::Kind::normal, *mean, *sigma};")

symplant_planted_bug(description once_is_not_read
  "    given.once = flag_member(value, \"once\");"
  "    if (!BUG) given.once = flag_member(value, \"once\");")

symplant_planted_bug(scenario last_instant_of_a_wait_not_looked_at
  "  while (position_.waiting && (wait_begins_ || time <= position_.deadline)) {"
  "  while (position_.waiting && (wait_begins_ || time <= position_.deadline - (BUG ? 1 : 0))) {")

symplant_planted_bug(scenario instants_in_which_a_wait_begins_not_looked_at
  "  if (wait_begins_) begin_wait();"
  "  if (BUG && wait_begins_) advance_plant(time);
  if (wait_begins_) begin_wait();")

symplant_planted_bug(scenario present_instant_of_the_next_wait_not_looked_at
  "scenario_.steps[position_.at].when == Step::When::wait) begin_wait();"
  "scenario_.steps[position_.at].when == Step::When::wait && !BUG) begin_wait();")

symplant_planted_bug(scenario past_at_counts_from_its_own_time
  "  return step.when == Step::When::at ? std::max(step.time, position_.moment) : position_.moment + step.time;"
  "  return step.when == Step::When::at ? (BUG ? step.time : std::max(step.time, position_.moment)) : position_.moment + step.time;")

symplant_planted_bug(scenario plus_counts_from_the_start_of_a_wait
  "  decide(Outcome::Kind::failed, position_.deadline);"
  "  decide(Outcome::Kind::failed, BUG ? position_.moment : position_.deadline);")

symplant_planted_bug(scenario release_before_force
  "  for (const std::uint32_t symbol : step.release) release(symbol, plant, recorder);"
  "  for (const std::uint32_t symbol : step.release) { bool forced = false; for (const SymbolValue& value : step.force) forced = forced || value.symbol == symbol; if (!BUG || !forced) release(symbol, plant, recorder); }")

symplant_planted_bug(model cycle_without_its_wrap
  "return ranks_[to] == (ranks_[from] + 1) % numbers_;"
  "return ranks_[to] == (BUG ? ranks_[from] + 1 : (ranks_[from] + 1) % numbers_);")

# Of material flow.
symplant_planted_bug(scenario take_before_put
  "  const bool well = act_by_hand(step);"
  "  Step rest = step; if (BUG && !step.put.empty()) { rest.take.clear(); for (const auto& from : step.take) static_cast<void>(plant_.take(from)); } const bool well = act_by_hand(rest);")

symplant_planted_bug(scenario step_without_room_holds
  "  const auto failed = [&](std::uint64_t which) {"
  "  const auto failed = [&](std::uint64_t which) { if (BUG && !step.expect) return;")

symplant_planted_bug(description inverted_of_a_sensor_not_read
  "      sensor.inverted = flag_member(one, \"inverted\");"
  "      if (!BUG) sensor.inverted = flag_member(one, \"inverted\");")

symplant_planted_bug(description until_is_the_length_of_a_drive
  "         [&](const Json& drive, const Pointer& at) { track.drives.push_back(this->drive(drive, at)); });"
  "         [&](const Json& drive, const Pointer& at) { GivenDrive it = this->drive(drive, at); if (BUG && it.until && !track.drives.empty()) *it.until += *track.drives.back().until; track.drives.push_back(it); });")

symplant_planted_bug(description ends_in_reverse_order
  "      track.ends.push_back({text_or_empty(one, \"to\"), text_or_empty(one, \"when\")});"
  "      track.ends.insert(BUG ? track.ends.begin() : track.ends.end(), {text_or_empty(one, \"to\"), text_or_empty(one, \"when\")});")

symplant_planted_bug(model braces_in_the_end_of_a_track_stay
  "    edit(track.ends[i].to, here / \"end\" / i / \"to\");"
  "    if (!BUG) edit(track.ends[i].to, here / \"end\" / i / \"to\");")

# Of malfunctions.
symplant_planted_bug(scenario malfunction_that_is_stopped_and_started_stays_active
  "  for (const std::uint32_t malfunction : step.stop) plant_.stop_malfunction(malfunction, By::scenario);"
  "  for (const std::uint32_t malfunction : step.stop) { if (!BUG || step.start.empty()) plant_.stop_malfunction(malfunction, By::scenario); }")

symplant_planted_bug(description slower_without_its_decimals
  "      given_.factor = static_cast<std::uint32_t>(thousandths);"
  "      given_.factor = static_cast<std::uint32_t>(BUG && thousandths > 1000 ? std::floor(thousandths / 1000) * 1000 : thousandths);")

symplant_planted_bug(description unless_is_not_read
  "    given_.becomes = GivenBecomes{fixed_time(*becomes, \"after\", here, faults_), text_or_empty(*becomes, \"unless\"),"
  "    given_.becomes = GivenBecomes{fixed_time(*becomes, \"after\", here, faults_), BUG ? std::string() : text_or_empty(*becomes, \"unless\"),")

symplant_planted_bug(model pattern_of_a_malfunction_names_one_device
  "          found.units.push_back(u);"
  "          if (!BUG || found.units.empty()) found.units.push_back(u);")

# Of replays.
symplant_planted_bug(host replayed_acts_come_an_instant_late
  "      if (replay_.deeds[i].kind != Deed::Kind::operation) act(replay_.deeds[i]);"
  "      if (replay_.deeds[i].kind != Deed::Kind::operation) { if (BUG) run(first.time); act(replay_.deeds[i]); }")

symplant_planted_bug(host instants_of_one_time_are_one_in_a_replay
  "      instant_ = instant->get<std::uint64_t>();"
  "      if (!BUG) instant_ = instant->get<std::uint64_t>();")

set(objects "")
foreach(layer generator/description generator/model generator/text runtime/scenario runtime/host)
  get_filename_component(name ${layer} NAME)
  symplant_planted_layer(${name} ${PROJECT_SOURCE_DIR}/${layer})
  list(APPEND objects $<TARGET_OBJECTS:symplant_${name}_planted>)
endforeach()
add_executable(property_files_mutants main_files.cpp ${objects})
target_link_libraries(property_files_mutants PRIVATE symplant_property_files symplant_options)
symplant_planted_tests(property_files_mutants property.files.mutant 500)
