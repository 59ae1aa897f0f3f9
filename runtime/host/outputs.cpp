// Writes the records of a run to its output files and its report.
#include "symplant/host/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <stop_token>
#include <utility>

#include "symplant/host/files_apart.hpp"
#include "symplant/scenario/step_text.hpp"

namespace symplant::host {
namespace {

constexpr auto kFlush = std::chrono::milliseconds(50);
constexpr std::uint64_t kDrainsToLook = 64;  // at the clock: a step of a run is shorter than a look

/// Reports the error of a file; false if there is one.
template <class File>
bool is_well(const std::optional<File>& file, std::ostream& err) {
  if (!file || file->error().empty()) return true;
  err << "error: " << file->error() << "\n";
  return false;
}

}  // namespace

ActText act_of(const scenario::Scenario& scenario, std::uint64_t step, const trace::PlantNames& names) {
  return {scenario::act_json(scenario.steps[step], names), "scenario"};
}

bool records_changes(const RunOptions& options) {
  return !options.trace.empty() || !options.vcd.empty() || options.records;
}

bool counts_utilization(const RunOptions& options) { return options.panel || !options.stats.empty(); }

Outputs::Outputs(const trace::PlantNames& names, const RunOptions& options, trace::Recorder& recorder,
                 trace::History& history, Report& report, std::ostream& out)
    : names_(names), options_(options), recorder_(recorder), history_(history), report_(report), out_(out) {
  if (counts_utilization(options)) utilization_.emplace(names, history);
}

trace::OutputFile Outputs::file(const char* what, const std::string& path, std::uint64_t limit) const {
  return is_standard_output(path) ? trace::OutputFile(what, out_) : trace::OutputFile(what, path, limit);
}

bool Outputs::open(std::uint64_t model_hash, tables::Time cycle, std::ostream& err) {
  if (!options_.trace.empty()) {
    trace_.emplace(file("trace", options_.trace, options_.trace_limit), names_.tables(), model_hash, options_.seed,
                   cycle, names_.programs());
  }
  if (!options_.vcd.empty()) vcd_.emplace(file("VCD file", options_.vcd, options_.trace_limit), names_);
  if (!options_.findings.empty()) findings_.emplace(file("findings", options_.findings, trace::kNoLimit), names_);
  const bool trace = is_well(trace_, err);
  const bool vcd = is_well(vcd_, err);
  return is_well(findings_, err) && trace && vcd;
}

void Outputs::take(const trace::Record& record) {
  using Kind = trace::Record::Kind;
  if (record.kind != Kind::part && record.kind != Kind::part_move && record.kind != Kind::malfunction &&
      record.kind != Kind::value) {
    write(record);
    if (record.kind == Kind::note) return;
  } else {
    later_.push_back(record);
  }
  if (!record.last) return;
  for (const trace::Record& one : later_) write(one);
  later_.clear();
  const bool of_host = record.kind == Kind::finding && trace::is_of_host(record.finding);
  if (!of_host) ++instants_;
  end_instant(record.time);
}

void Outputs::write(const trace::Record& record) {
  using Kind = trace::Record::Kind;
  if (record.kind == Kind::note) return take_note(record);
  if (panel_ != nullptr) panel_->before(record);
  history_.apply(record);
  if (panel_ != nullptr) panel_->after(record);
  if (utilization_) utilization_->apply(record);
  if (record.kind == Kind::change) ++changes_;
  if (record.kind == Kind::finding) {
    if (loop_goes_on_) {
      found_.back().of.push_back(record.of);
    } else {
      found_.push_back({record.time, record.finding, {record.of}, record.value});
    }
    loop_goes_on_ = record.more;
  }
  if (options_.records) options_.records(record);
  if (trace_) trace_->write(record);
  if (vcd_ && vcd_end_ < 0) vcd_->write(record);
}

void Outputs::take_note(const trace::Record& record) {
  if (record.of == scenario::kTurnNote) {
    turn_ = record.value;
  } else if (record.of == scenario::kForceNote) {
    history_.force(static_cast<std::uint32_t>(record.value / 2), record.value % 2 != 0, record.time);
  } else if (record.of == scenario::kHandNote) {
    hands_.push_back(record.value);
  } else if (record.of < scenario::kLeastNote) {
    report_.failed(record.of, std::exchange(turn_, 0), static_cast<tables::Time>(record.value), hands_);
    hands_.clear();
  }
  if (trace_) trace_note(record);
  if (panel_ == nullptr) return;
  if (const auto jump = panel_->note(record)) set_back(jump->what, jump->name, jump->time);
  if (trace_) {
    for (const std::string& act : panel_->take_acts()) trace_->act(record.time, act, "hand");
  }
}

/// What a replay of the trace needs.
void Outputs::trace_note(const trace::Record& record) {
  if (record.of == trace::kInstantNote) {
    trace_->instant(record.time, record.value);
  } else if (record.of == trace::kActNote) {
    const bool of_panel = panel_ != nullptr && !is_run_act(record.value);
    const scenario::Scenario* const playing = of_panel ? panel_->playing() : nullptr;
    const ActText act = playing != nullptr         ? act_of(*playing, record.value, names_)
                        : is_run_act(record.value) ? text_of_run_act(record.value, names_)
                                                   : act_text_(record.value);
    trace_->act(record.time, act.json, act.by);
  } else if (record.of == trace::kQualityNote) {
    const std::uint32_t unit = names_.tables().behaviour_units[record.value / 2].unit;
    trace_->quality(record.time, names_.unit(unit), record.value % 2 != 0);
  }
}

void Outputs::end_instant(tables::Time time) {
  loop_goes_on_ = false;
  for (const trace::FoundThing& found : found_) {
    const bool too_short = found.kind == tables::FindingKind::event_too_short;
    if (too_short && !carried_.empty() && !carried_[found.of.front()]) continue;
    const std::string words = report_.found(found);
    if (panel_ != nullptr) panel_->finding(found, words);
    if (findings_) findings_->write(found, words, history_);
  }
  found_.clear();
  last_time_ = time;
  if (vcd_ && vcd_end_ < 0) {
    vcd_->begin(time, history_);
    vcd_->part(time, history_);
  }
  if (trace_) trace_->part(time, history_);
}

void Outputs::set_back(std::string_view what, std::string_view name, tables::Time time) {
  trace_alarm_acts();  // they were before it
  if (trace_) trace_->set_back(what, name, time, history_);
  if (utilization_) utilization_->begin(time);
  if (vcd_ && vcd_->has_begun() && vcd_end_ < 0) vcd_end_ = last_time_;
  last_time_ = time;
}

/// What a person did with alarms does not touch the plant, so it has no record.
void Outputs::trace_alarm_acts() {
  if (panel_ == nullptr) return;
  for (const panel::AlarmAct& act : panel_->take_alarm_acts()) {
    if (trace_) trace_->act(std::max(act.time, last_time_), act.json, "hand");
  }
}

void Outputs::hide() {
  if (panel_ == nullptr) return;
  {
    const auto lock = panel_->lock();
    trace_alarm_acts();
  }
  panel_ = nullptr;
}

void Outputs::drain() {
  const auto lock = panel_ != nullptr ? panel_->lock() : std::unique_lock<std::mutex>();
  report_.report_hidden(false);
  recorder_.drain([this](const trace::Record& record) { take(record); });
  trace_alarm_acts();
  if (++drains_ % kDrainsToLook == 0) flush_when_due();
}

void Outputs::flush_when_due() {
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < kFlush) return;
  flushed_ = now;
  flush();
}

void Outputs::flush() {
  if (trace_) trace_->flush();
  if (vcd_) vcd_->flush();
  if (findings_) findings_->flush();
  report_errors();
}

/// A file that cannot be written any more ends there; the plant runs on.
void Outputs::report_errors() {
  const auto report = [this](const auto& file) {
    if (!file || file->error().empty() || !reported_.insert(file->error()).second) return;
    report_.warn(file->error() + "; the file ends here");
  };
  report(trace_);
  report(vcd_);
  report(findings_);
}

void Outputs::start_thread() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      drain();
      flush();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
}

void Outputs::stop_thread() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void Outputs::finish(tables::Time end, std::ostream& err) {
  drain();
  if (vcd_) {
    vcd_->begin(0, history_);
    vcd_->end(vcd_end_ < 0 ? end : vcd_end_);
  }
  if (vcd_end_ >= 0) {
    err << fmt::format("warning: the VCD file ends at {}, when the plant was set back: its time cannot go back\n",
                       trace::seconds(vcd_end_));
  }
  if (trace_ && recorder_.lost_changes() != 0) trace_->lost(std::max(end, last_time_), recorder_.lost_changes());
  flush();
  if (recorder_.lost_changes() != 0) {
    err << fmt::format("warning: {} changes {}\n", recorder_.lost_changes(),
                       records_changes(options_)
                           ? "are missing in the trace and the VCD file: the disk was too slow"
                           : "came too fast to be recorded: findings may describe an earlier state");
  }
}

}  // namespace symplant::host
