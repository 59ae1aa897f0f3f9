// Scenarios as text, read for a plant made of names, and played on it.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/scenario/read_scenario.hpp"
#include "symplant/scenario/verdict.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::test {

using tables::kSecond;

/// `steps` between the brackets of a scenario, starting at line 1.
inline std::string scenario_text(const std::string& steps) {
  return R"({"symplant-scenario":1,"steps":[)" + steps + "]}";
}

/// Faults as "column: message", one per line.
inline std::string faults_text(std::string_view text, const std::vector<json::Placed>& faults) {
  std::string all;
  for (const json::Placed& fault : faults) {
    const json::LineColumn at = json::line_and_column(text, fault.span.begin);
    all += std::to_string(at.line) + ":" + std::to_string(at.column) + " `" +
           std::string(text.substr(fault.span.begin, fault.span.end - fault.span.begin)) + "` " + fault.message + "\n";
  }
  return all;
}

/// A scenario played in virtual time, to its end or to a time.
class Play {
 public:
  using Files = std::map<std::string, std::string>;  ///< that the scenario can include, by path

  Play(const BenchTables& tables, const std::string& steps, tables::Time until = tables::kNever, tables::Time cycle = 0,
       Files files = {})
      : tables_(tables),
        files_(std::move(files)),
        names_(tables.rows),
        history_(names_),
        explainer_(names_),
        scenario_(read(steps)),
        plant(tables.rows),
        recorder_(tables.rows, 1024),
        player_(scenario_, plant, recorder_) {
    recorder_.attach(plant);
    advance(0);
    if (cycle == 0) {
      play_virtual(until);
    } else {
      for (tables::Time time = cycle; time <= until && !player_.over(); time += cycle) advance(time);
    }
    player_.end();
  }

  /// "500:AGV_I_P1=0 ...": every change in its order, times in ms; a bar between two instants of one time.
  const std::string& changes() const { return changes_; }
  /// One letter per step: d(one), h(eld), f(ailed), u(nreached).
  std::string outcomes() const {
    std::string text;
    for (const scenario::Outcome& outcome : player_.outcomes()) text += "pdhfu"[static_cast<int>(outcome.kind)];
    return text;
  }
  scenario::Verdict verdict() const { return scenario::verdict_of(scenario_, player_.outcomes()); }
  tables::Time time_of(std::size_t step) const { return player_.outcomes()[step].time / kMs; }
  /// Messages of failed steps, one per line.
  const std::string& failures() const { return failures_; }

 private:
  scenario::Scenario read(const std::string& steps) const {
    const std::string text = scenario_text(steps);
    auto result = scenario::read_scenario(text, names_, {}, [this](const std::string& path) -> scenario::OpenedFile {
      const auto found = files_.find(path);
      if (found == files_.end()) return {std::nullopt, "No such file or directory"};
      return {found->second, ""};
    });
    INFO((result.faults.empty() ? "" : faults_text(text, result.faults.front().faults)));
    REQUIRE(result.scenario);
    return std::move(*result.scenario);
  }
  void play_virtual(tables::Time until) {
    for (;;) {
      if (player_.over() && until == tables::kNever) return;
      const tables::Time due = std::min(plant.next_due(), player_.next());
      if (due > until) return advance(until);
      if (due == tables::kNever) return;
      advance(due);
    }
  }
  void advance(tables::Time time) {
    player_.advance_to(time);
    recorder_.drain([this](const trace::Record& record) { take(record); });
  }
  void take(const trace::Record& record) {
    history_.apply(record);
    if (record.kind == trace::Record::Kind::note && record.of == scenario::kForceNote) return;
    if (record.kind == trace::Record::Kind::note && record.of == scenario::kTurnNote) {
      turn_ = record.value;
      return;
    }
    if (record.kind == trace::Record::Kind::note && record.of == scenario::kHandNote) {
      hands_.push_back(record.value);
      return;
    }
    if (record.kind == trace::Record::Kind::note && record.of >= scenario::kLeastNote) return;
    if (record.kind == trace::Record::Kind::note) {
      const std::vector<std::uint64_t> hands = std::exchange(hands_, {});
      const scenario::Failure failure{record.of, turn_, static_cast<tables::Time>(record.value), hands};
      failures_ += why::in_one_line(scenario::failure_words(scenario_, failure, explainer_, history_, &plant)) + "\n";
      return;
    }
    if (record.kind == trace::Record::Kind::change) {
      const std::string value = trace::json_value(tables_.rows.symbols[record.of].type(), record.value);
      if (ended_ && record.time == last_) changes_ += " |";
      ended_ = false;
      last_ = record.time;
      changes_ += (changes_.empty() ? "" : " ") + std::to_string(record.time / kMs) + ":" +
                  tables_.symbol_name(record.of) + "=" +
                  (value == "true"    ? "1"
                   : value == "false" ? "0"
                                      : value);
    }
    if (record.last) ended_ = true;
  }

  const BenchTables& tables_;
  const Files files_;
  std::uint64_t turn_ = 0;
  std::vector<std::uint64_t> hands_;  ///< what failed by hand in the step whose failure is next
  trace::PlantNames names_;
  trace::History history_;
  why::Explainer explainer_;
  scenario::Scenario scenario_;

 public:
  plant::OwnedPlant plant;

 private:
  trace::Recorder recorder_;
  scenario::Player player_;
  std::string changes_;
  std::string failures_;
  tables::Time last_ = -1;
  bool ended_ = false;
};

/// The paper's vehicle; tests omit L_P_ in symbol names.
inline const std::vector<std::string> kAgv = {"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"};

}  // namespace symplant::test
