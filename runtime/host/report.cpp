// Reports the findings and failures of a run.
#include "symplant/host/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "symplant/host/words.hpp"
#include "symplant/tables/pattern.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::host {
namespace {

using tables::FindingKind;
using trace::seconds;

const char* severity(FindingKind kind) {
  if (kind == FindingKind::requirement_violated) return "error";
  return kind == FindingKind::started_on_enabling || kind == FindingKind::link_back ? "note" : "warning";
}

}  // namespace

Report::Report(const why::Explainer& explainer, const trace::History& history, const plant::Plant* plant,
               const scenario::Scenario* scenario, std::string file, std::span<const IgnoredFinding> ignored,
               Console& console)
    : names_(explainer.names()),
      explainer_(explainer),
      history_(history),
      plant_(plant),
      scenario_(scenario),
      file_(std::move(file)),
      console_(console),
      violations_(names_.tables().requirements.size()),
      failures_(scenario == nullptr ? 0 : scenario->steps.size()) {
  const std::string date = ignored.empty() ? std::string() : today();
  std::copy_if(ignored.begin(), ignored.end(), std::back_inserter(ignored_entries_),
               [&](const IgnoredFinding& entry) { return entry.until.empty() || date <= entry.until; });
}

std::string Report::location(std::size_t step) const {
  const scenario::Step& its = scenario_->steps[step];
  return fmt::format("{}:{}", shown(its.file == 0 ? file_ : scenario_->files[its.file]), its.line);
}

void Report::report(std::string head, const why::Explanation& explanation) {
  for (const std::string& line : why::lines_of(explanation)) head += shown(line) + "\n";
  console_.message(head);
}

why::Explanation Report::words_of(const trace::FoundThing& found) const {
  if (found.kind != FindingKind::requirement_violated) return {trace::finding_words(found, names_, history_)};
  return explainer_.violation(found.of.front(), why::RecordedView(history_, found.time, plant_));
}

std::string Report::found(const trace::FoundThing& found) {
  const why::Explanation explanation = words_of(found);
  std::string words = why::in_one_line(explanation);
  if (is_ignored(found)) {
    ++ignored_;
    return words;
  }
  if (counts_[static_cast<std::size_t>(found.kind)]++ == 0) first_words_[static_cast<std::size_t>(found.kind)] = words;
  if (found.kind == FindingKind::requirement_violated) {
    Violation& violation = violations_[found.of.front()];
    if (violation.count++ == 0) {
      violation.first = found.time;
      violation.words = words;
    }
  }
  if (is_shown(found)) report(fmt::format("{}: {}: ", severity(found.kind), seconds(found.time)), explanation);
  return words;
}

/// By the kind, and the name of the finding or of one of its devices.
bool Report::is_ignored(const trace::FoundThing& found) const {
  if (ignored_entries_.empty() || found.kind == FindingKind::requirement_violated) return false;
  std::vector<std::string> names{trace::name_of(found, names_)};
  for (const std::uint32_t unit : trace::units_of(found, names_.tables())) names.emplace_back(names_.unit(unit));
  return std::any_of(ignored_entries_.begin(), ignored_entries_.end(), [&](const IgnoredFinding& entry) {
    return entry.finding == trace::finding_name(found.kind) &&
           (entry.of.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
              return tables::matches_pattern(name, entry.of);
            }));
  });
}

/// The first finding of each kind and thing. A loss of a link and a standstill are shown each time, as their limit
/// allows.
bool Report::is_shown(const trace::FoundThing& found) {
  if (!trace::is_of_host(found.kind)) return reported_.emplace(found.kind, found.of).second;
  return limits_[{found.kind, trace::name_of(found, names_)}].admits(LineLimit::Clock::now());
}

void Report::report_hidden(bool at_end) {
  if (limits_.empty()) return;
  const auto now = LineLimit::Clock::now();
  for (auto& [subject, limit] : limits_) {
    const std::uint64_t hidden = limit.take_hidden(now, at_end);
    if (hidden == 0) continue;
    console_.message(fmt::format("{}: {}: {}, {} more within {} s, not shown\n", severity(subject.first),
                                 trace::finding_name(subject.first), shown(subject.second), hidden,
                                 LineLimit::kWindow.count()));
  }
}

void Report::failed(std::uint32_t step, std::uint64_t turn, tables::Time time, std::span<const std::uint64_t> hands) {
  if (!failures_[step].empty()) return;
  const why::Explanation explanation =
      scenario::failure_words(*scenario_, {step, turn, time, hands}, explainer_, history_, plant_);
  failures_[step] = why::in_one_line(explanation);
  report(location(step) + ": error: ", explanation);
}

std::uint64_t Report::findings() const { return std::accumulate(counts_.begin(), counts_.end(), lost_); }

std::size_t Report::requirements_violated() const {
  return static_cast<std::size_t>(
      std::count_if(violations_.begin(), violations_.end(), [](const Violation& v) { return v.count != 0; }));
}

void Report::report_unreached(const plant::Plant& plant, std::span<const scenario::Outcome> outcomes) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].kind != scenario::Outcome::Kind::unreached || !scenario_->steps[i].is_checked()) continue;
    const std::string turn = scenario::turn_words(*scenario_, i, outcomes[i].done);
    failures_[i] = fmt::format("{} was not reached{}, since the run ended at {}",
                               scenario::expectation_words(scenario_->steps[i], names_),
                               turn.empty() ? "" : " in " + turn, seconds(plant.now()));
    console_.message(fmt::format("{}: error: {}\n", location(i), shown(failures_[i])));
  }
}

void Report::report_findings(std::ostream& out) const {
  std::string text;
  for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
    if (counts_[kind] == 0) continue;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", trace::finding_name(static_cast<FindingKind>(kind)),
                        counts_[kind]);
  }
  if (!text.empty()) out << "findings: " << text << "\n";
  if (ignored_ != 0) out << fmt::format("findings: {} ignored, as plant.json says\n", ignored_);
  if (lost_ != 0) out << fmt::format("findings: {} more are lost, since they came too fast to be written\n", lost_);
}

void Report::report_requirements(const plant::Plant& plant, std::ostream& out) const {
  if (violations_.empty()) return;
  const std::size_t violated = requirements_violated();
  out << fmt::format("requirements: {} held, {} violated\n", violations_.size() - violated, violated);
  for (std::uint32_t r = 0; r < violations_.size(); ++r) {
    if (plant.is_pending(r)) {
      out << fmt::format("pending at the end: `{}` still waits for what it expects\n", shown(names_.requirement(r)));
    }
  }
}

void Report::report_disarmed(const plant::Plant& plant, std::ostream& out) const {
  const auto disarmed = plant.disarmed();
  for (std::uint32_t symbol = 0; symbol < names_.tables().symbols.size(); ++symbol) {
    const tables::SymbolRow& row = names_.tables().symbols[symbol];
    if (row.type() != tables::DataType::boolean || !names_.is_operation(symbol) || row.unit == tables::kNone) continue;
    const bool commands = plant.operation(row.index) != row.inverted();
    if ((disarmed[row.index / 64] >> (row.index % 64) & 1) == 0 || !commands) continue;
    out << fmt::format("still on, without effect until it goes off and on again: {}\n",
                       shown(trace::symbol_words(symbol, names_)));
  }
}

void Report::sum_up(const plant::Plant& plant, std::span<const scenario::Outcome> outcomes, std::uint64_t lost_findings,
                    std::ostream& out) {
  report_hidden(true);
  lost_ = lost_findings;
  if (scenario_ != nullptr) {
    report_unreached(plant, outcomes);
    const scenario::Verdict verdict = scenario::verdict_of(*scenario_, outcomes);
    out << fmt::format("expectations: {} held, {} failed, {} not reached\n", verdict.held, verdict.failed,
                       verdict.unreached);
  }
  report_requirements(plant, out);
  report_findings(out);
  report_disarmed(plant, out);
}

}  // namespace symplant::host
