// Reports the findings and failures of a run: as they happen, counted, and summed up at the end.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "symplant/host/console.hpp"
#include "symplant/host/line_limit.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/scenario/verdict.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/why/explainer.hpp"

namespace symplant::host {

/// Violations of one requirement.
struct Violation {
  std::uint64_t count = 0;
  tables::Time first = 0;
  std::string words;  ///< of the first violation
};

/// Used by one thread at a time. Names, history, scenario and the console must outlive it.
class Report {
 public:
  /// `scenario` may be null; `file` is its path, for messages. Findings that an entry of `ignored` matches today are
  /// only counted; a violated requirement never is. `plant` is null if another thread runs it.
  Report(const why::Explainer& explainer, const trace::History& history, const plant::Plant* plant,
         const scenario::Scenario* scenario, std::string file, std::span<const IgnoredFinding> ignored,
         Console& console);

  /// Counts a finding, and reports the first of each kind and subject. Returns its text.
  std::string found(const trace::FoundThing& found);
  /// Reports that step `step` failed at `time`; only the first failure of each step is reported. `turn`: how often the
  /// step was done before. `hands`: the actions that were refused, as values of scenario::kHandNote.
  void failed(std::uint32_t step, std::uint64_t turn, tables::Time time, std::span<const std::uint64_t> hands);

  /// A warning that is not a finding, in one line.
  void warn(const std::string& text) { console_.message("warning: " + text + "\n"); }

  /// Whether an entry of `ignored` matches it today.
  bool is_ignored(const trace::FoundThing& found) const;
  /// Reports how many findings of links and standstills were not shown: of those whose ten seconds are over, or of all
  /// `at_end`. To be called from time to time.
  void report_hidden(bool at_end);

  std::uint64_t count(tables::FindingKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  /// The number of findings, without the ignored ones. After sum_up() it includes those that came too fast to be
  /// written.
  std::uint64_t findings() const;
  /// The first finding of a kind that is not ignored; empty if there is none.
  const std::string& words(tables::FindingKind kind) const { return first_words_[static_cast<std::size_t>(kind)]; }
  const Violation& violation(std::uint32_t requirement) const { return violations_[requirement]; }
  /// Why a step failed; empty if it did not fail.
  const std::string& failure(std::size_t step) const { return failures_[step]; }

  /// To be called at the end: reports unreached expectations as messages, and on `out` the counts, pending
  /// requirements, and operations that are on without effect. `outcomes` are those of the scenario, if there is one.
  void sum_up(const plant::Plant& plant, std::span<const scenario::Outcome> outcomes, std::uint64_t lost_findings,
              std::ostream& out);

  std::size_t requirements_violated() const;

 private:
  void report_unreached(const plant::Plant& plant, std::span<const scenario::Outcome> outcomes);
  void report_findings(std::ostream& out) const;
  void report_requirements(const plant::Plant& plant, std::ostream& out) const;
  void report_disarmed(const plant::Plant& plant, std::ostream& out) const;
  std::string location(std::size_t step) const;
  bool is_shown(const trace::FoundThing& found);
  why::Explanation words_of(const trace::FoundThing& found) const;
  /// Writes each sentence as a line: the first after `head`, the others indented.
  void report(std::string head, const why::Explanation& explanation);

  const trace::PlantNames& names_;
  const why::Explainer& explainer_;
  const trace::History& history_;
  const plant::Plant* plant_;
  const scenario::Scenario* scenario_;
  std::string file_;
  std::vector<IgnoredFinding> ignored_entries_;  ///< those that are valid today
  Console& console_;
  std::uint64_t ignored_ = 0;
  std::map<std::pair<tables::FindingKind, std::string>, LineLimit>
      limits_;  ///< of the host's findings, by kind and name
  std::array<std::uint64_t, tables::kAllFindingKinds> counts_{};
  std::array<std::string, tables::kAllFindingKinds> first_words_;
  std::uint64_t lost_ = 0;
  std::set<std::pair<tables::FindingKind, std::vector<std::uint32_t>>> reported_;
  std::vector<Violation> violations_;
  std::vector<std::string> failures_;
};

}  // namespace symplant::host
