// Writes the records of a run to its output files and its report.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "symplant/host/report.hpp"
#include "symplant/host/run_acts.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/panel/panel.hpp"
#include "symplant/trace/finding_file.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/trace_file.hpp"
#include "symplant/trace/utilization.hpp"
#include "symplant/trace/vcd_file.hpp"

namespace symplant::host {

/// Whether a file gets every change of the plant.
bool records_changes(const RunOptions& options);
/// Whether the utilization of the plant is counted, which needs every change and the motions of parts.
bool counts_utilization(const RunOptions& options);

/// The act of a scenario's step.
ActText act_of(const scenario::Scenario& scenario, std::uint64_t step, const trace::PlantNames& names);

/// Drains a recorder: in virtual time after each step of the run, in real time on a separate thread, so that the cycle
/// never waits for a disk. All arguments of the constructor must outlive it.
class Outputs {
 public:
  /// `out` is standard output, for files with the path `-`.
  Outputs(const trace::PlantNames& names, const RunOptions& options, trace::Recorder& recorder, trace::History& history,
          Report& report, std::ostream& out);

  /// `event too short` is reported of these symbols only: no PLC can miss an event that no link carries.
  void report_short_events_of(std::vector<bool> symbols) { carried_ = std::move(symbols); }
  /// A panel that gets every record, too. It must outlive the last drain().
  void show_on(panel::Panel& panel) { panel_ = &panel; }
  void hide();
  /// Sets the function that gives the text of an act for traces, by its index: that of a step of the scenario.
  void write_acts(std::function<ActText(std::uint64_t)> text_of) { act_text_ = std::move(text_of); }
  /// Opens the files; they also get earlier records. `cycle`: in real time; 0: virtual time. False, with a message on
  /// `err`, if one cannot be opened.
  bool open(std::uint64_t model_hash, tables::Time cycle, std::ostream& err);

  /// Records that the plant was set to another state, which the history already has: writes a line to the trace, and
  /// ends the VCD file, since its time cannot go back. `what` and `name` as for TraceFile::set_back().
  void set_back(std::string_view what, std::string_view name, tables::Time time);
  void drain();
  /// Passes the files on to the system if that is due, so that a killed process loses at most the latest 100 ms.
  /// drain() does it from time to time; code that drains less often than each ms must call it.
  void flush_when_due();
  void start_thread();
  void stop_thread();
  /// Writes the remaining records, and reports on `err` what is missing.
  void finish(tables::Time end, std::ostream& err);

  /// What devices, tracks and places did; null without a panel and `--stats`. Until finish(), only for the thread that
  /// drains, or under the lock of the panel.
  trace::Utilization* utilization() { return utilization_ ? &*utilization_ : nullptr; }
  const trace::Utilization* utilization() const { return utilization_ ? &*utilization_ : nullptr; }
  std::uint64_t changes() const { return changes_; }
  std::uint64_t instants() const { return instants_; }

 private:
  trace::OutputFile file(const char* what, const std::string& path, std::uint64_t limit) const;
  void take(const trace::Record& record);
  void take_note(const trace::Record& record);
  void trace_note(const trace::Record& record);
  void trace_alarm_acts();
  void write(const trace::Record& record);
  void end_instant(tables::Time time);
  void flush();
  void report_errors();

  const trace::PlantNames& names_;
  const RunOptions& options_;
  trace::Recorder& recorder_;
  trace::History& history_;
  Report& report_;
  std::ostream& out_;
  panel::Panel* panel_ = nullptr;
  std::function<ActText(std::uint64_t)> act_text_;
  std::optional<trace::TraceFile> trace_;
  std::optional<trace::VcdFile> vcd_;
  std::optional<trace::FindingFile> findings_;
  std::optional<trace::Utilization> utilization_;
  std::vector<std::uint64_t> hands_;  ///< actions that were refused in the step whose failure is reported next
  std::vector<trace::Record>
      later_;  ///< of parts and malfunctions, of the instant that is being drained: they come last
  std::vector<trace::FoundThing> found_;  ///< findings of the instant that is being drained
  std::vector<bool> carried_;             ///< by symbol; empty: all
  std::uint64_t turn_ = 0;                ///< the turn of the failed step in the next note
  bool loop_goes_on_ = false;
  tables::Time last_time_ = 0;  ///< of the last instant
  tables::Time vcd_end_ = -1;   ///< when the plant was set back, and the VCD file ended; -1: it goes on
  std::uint64_t changes_ = 0;
  std::uint64_t instants_ = 0;
  std::uint64_t drains_ = 0;
  std::chrono::steady_clock::time_point flushed_ = {};
  std::set<std::string> reported_;  ///< errors of files
  std::jthread thread_;
};

}  // namespace symplant::host
