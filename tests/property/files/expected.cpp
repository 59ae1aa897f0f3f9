// Runs a case on the reference.
#include "property/files/expected.hpp"

#include <cstdio>
#include <map>

#include "lower/lower.hpp"
#include "property/files/plant_json.hpp"
#include "property/files/random_hands.hpp"
#include "property/files/random_scenario.hpp"
#include "property/files/resolved_steps.hpp"
#include "property/files/scenario_json.hpp"
#include "support/reference/lines.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::property::files {
namespace {

using When = Step::When;

bool is_case(const model::Derived& derived) {
  return derived.evidence.faults.empty() && derived.evidence.driven_twice.empty() && drives_are_complete(derived.plant);
}

std::string header_of(const model::PlantModel& plant, std::uint64_t seed) {
  const lower::EngineTables tables = lower::lower(plant);
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(tables::model_hash(tables.tables())));
  return "{\"symplant-trace\":1,\"plant\":\"" + plant.name + "\",\"model_hash\":\"" + hash +
         "\",\"seed\":" + std::to_string(seed) + ",\"clock\":\"virtual\"}";
}

void count_actions(const Step& step, const model::PlantModel& plant, Counts& counts) {
  counts[Seen::sets] += std::ssize(step.set);
  for (const auto& [name, value] : step.set) {
    for (const model::Symbol& symbol : plant.symbols) {
      counts[Seen::sets_of_inputs] += symbol.name() == name && symbol.direction == tables::Direction::event ? 1 : 0;
    }
  }
  counts[Seen::states] += std::ssize(step.states);
  counts[Seen::puts_and_takes] += !step.put.empty() && !step.take.empty() ? 1 : 0;
  counts[Seen::lists_of_puts] += step.put.size() > 1 ? 1 : 0;
  counts[Seen::lists_of_takes] += step.take.size() > 1 ? 1 : 0;
  counts[Seen::forces] += std::ssize(step.force);
  counts[Seen::releases] += std::ssize(step.release);
  counts[Seen::malfunction_stops] += std::ssize(step.stop);
  counts[Seen::malfunction_starts] += std::ssize(step.start);
  counts[Seen::malfunction_stops_and_starts] += !step.stop.empty() && !step.start.empty() ? 1 : 0;
}

void count_verdict(const Step& step, const model::PlantModel& plant, const reference::Verdict& verdict,
                   tables::Time start, Counts& counts) {
  if (!verdict.reached) {
    ++counts[Seen::never_reached];
  } else if (step.when == When::wait) {
    ++(verdict.held ? counts[Seen::waits_met] : counts[Seen::waits_failed]);
    if (verdict.held && step.time && verdict.time > start && verdict.time == start + *step.time) {
      ++counts[Seen::waits_met_at_last];
    }
  } else if (step.expect.empty() && step.expect_condition.empty()) {
    counts[Seen::steps_by_hand_failed] += verdict.held ? 0 : 1;
  } else {
    ++(verdict.held ? counts[Seen::expectations_held] : counts[Seen::expectations_failed]);
    counts[Seen::expected_values] += std::ssize(step.expect);
    counts[Seen::expected_conditions] += step.expect_condition.empty() ? 0 : 1;
    counts[Seen::conditions_of_parts] += names_parts(step.expect_condition, plant.material) ? 1 : 0;
  }
}

void count_parts(const reference::Plant& reference, Counts& counts) {
  using What = engine::PartChange::What;
  using reference::Counted;
  counts[Seen::puts] += reference.counters[Counted::put_by_hand];
  counts[Seen::puts_failed] += reference.counters[Counted::put_refused];
  counts[Seen::takes] += reference.counters[Counted::taken_by_hand];
  counts[Seen::takes_failed] += reference.counters[Counted::take_refused];
  for (const reference::InstantRecord& instant : reference.instants()) {
    for (const engine::PartChange& change : instant.parts) {
      const bool gone = change.what == What::moved && change.to == tables::kOut;
      ++counts[gone                         ? Seen::parts_gone
               : change.what == What::made  ? Seen::parts_made
               : change.what == What::moved ? Seen::parts_moved
                                            : Seen::parts_changed];
    }
  }
  for (const reference::TrackWorld& track : reference.save().material.tracks) {
    counts[Seen::tracks_frozen] += track.frozen ? 1 : 0;
  }
}

void count_malfunctions(const reference::Plant& reference, Counts& counts) {
  using By = engine::MalfunctionChange::By;
  for (const reference::InstantRecord& instant : reference.instants()) {
    for (const engine::MalfunctionChange& change : instant.malfunctions) {
      ++counts[change.by == By::condition ? Seen::changed_by_condition
               : change.by == By::chance  ? Seen::changed_by_chance
               : change.by == By::becomes ? Seen::changed_by_becoming
               : change.by == By::end     ? Seen::changed_by_end
                                          : Seen::changed_by_scenario];
    }
  }
  counts[Seen::malfunction_starts_of_ordinary] += reference.counters[reference::Counted::ordinary_started];
  counts[Seen::malfunction_starts_refused] += reference.counters[reference::Counted::start_refused];
}

/// Plays all steps; false if the case is invalid.
class CountingRun {
 public:
  CountingRun(const FileCase& it, const model::PlantModel& plant, reference::Plant& reference, Counts& counts)
      : it_(it), plant_(plant), reference_(reference), counts_(counts), resolver_(plant) {}

  std::optional<std::vector<reference::Verdict>> play() {
    reference::ScenarioPlayer player(plant_, reference_, it_.until, 4 * most_instants(plant_));
    for (const Step& step : it_.steps) {
      const auto resolved = resolver_.resolve(step);
      if (!resolved) return std::nullopt;
      const tables::Time start = reference_.now();
      const std::size_t before = player.verdicts().size();
      player.play(*resolved);
      count(step, start, player.cut());
      if (player.verdicts().size() > before) count_verdict(step, plant_, player.verdicts().back(), start, counts_);
      if (player.met_before_a_further_instant()) ++counts_[Seen::waits_met_before_a_further_instant];
    }
    counts_[Seen::until_cut] += player.cut() ? 1 : 0;
    player.end();
    if (player.exhausted()) return std::nullopt;
    return player.verdicts();
  }

 private:
  void count(const Step& step, tables::Time start, bool cut) {
    if (cut || step.when == When::wait) return;
    ++(step.when == When::at ? counts_[Seen::at] : counts_[Seen::plus]);
    if (step.when == When::at && *step.time < start) ++counts_[Seen::at_past];
    count_actions(step, plant_, counts_);
    const bool same_time = reference_.now() == start;
    if (same_time && after_expect_ && !step.set.empty()) ++counts_[Seen::sets_behind_expect];
    after_expect_ = (same_time && after_expect_) || !step.expect.empty() || !step.expect_condition.empty();
  }

  const FileCase& it_;
  const model::PlantModel& plant_;
  reference::Plant& reference_;
  Counts& counts_;
  StepResolver resolver_;
  bool after_expect_ = false;
};

}  // namespace

std::optional<Outcome> expected(const FileCase& it, Counts& counts) {
  const model::Derived derived = build(it.plant);
  const model::PlantModel& plant = derived.plant;
  if (!is_case(derived)) return std::nullopt;
  reference::Plant reference(plant);
  reference.reset(it.seed);
  const auto verdicts = CountingRun(it, plant, reference, counts).play();
  if (!verdicts) return std::nullopt;
  count_parts(reference, counts);
  count_malfunctions(reference, counts);
  Outcome outcome;
  outcome.header = header_of(plant, it.seed);
  outcome.trace = reference::trace_lines(plant, reference.instants());
  outcome.findings = reference::finding_lines(plant, reference.instants());
  bool good = true;
  const auto add = [&](const std::string& name, bool held) {
    outcome.verdicts.push_back(name + (held ? " held" : " failed"));
    good = good && held;
  };
  const std::vector<std::size_t> numbers = numbers_in_file(it.steps);
  struct Judged {
    bool held;
    bool expects;
  };
  std::map<std::size_t, Judged> steps;  // a repeated step holds if it does in each turn
  for (const reference::Verdict& verdict : *verdicts) {
    const auto [step, added] = steps.try_emplace(numbers[verdict.step], Judged{verdict.held, verdict.expects});
    if (!added) step->second.held = step->second.held && verdict.held;
  }
  for (const auto& [step, judged] : steps) {
    if (judged.expects || !judged.held) add("step " + std::to_string(step + 1), judged.held);
  }
  std::vector<bool> violated(plant.requirements.size());
  for (const reference::InstantRecord& instant : reference.instants()) {
    for (const tables::Finding& finding : instant.findings) {
      ++counts.of(finding.kind);
      if (finding.kind == tables::FindingKind::requirement_violated) violated[finding.of] = true;
    }
  }
  for (std::size_t i = 0; i < violated.size(); ++i) add("requirement: " + plant.requirements[i].name, !violated[i]);
  outcome.code = good ? 0 : 1;
  ++(good ? counts[Seen::runs_good] : counts[Seen::runs_failed]);
  counts[Seen::until] += it.until ? 1 : 0;
  return outcome;
}

Files files_of(const FileCase& it, Counts& counts) {
  const PlantText& plant = it.plant;
  Files files;
  const std::size_t first_end = plant.two_lists() ? plant.second_list : plant.rows.size();
  files.lists.push_back(list_text(plant, 0, first_end));
  if (plant.two_lists()) files.lists.push_back(list_text(plant, first_end, plant.rows.size()));
  files.plant = plant_json(plant, it.style, counts);
  files.scenario = scenario_json(it.steps, build(plant).plant, it.style, counts);
  files.seed = it.seed;
  files.until = it.until;
  return files;
}

}  // namespace symplant::property::files
