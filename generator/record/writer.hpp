// Decides what a recording has, and writes it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "record/interval.hpp"
#include "record/kept_part.hpp"
#include "record/line.hpp"
#include "record/trigger.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/trace_file.hpp"

namespace symplant::record {

/// What is recorded. Times in ns.
struct What {
  std::string link;  ///< URL
  Time every = 0;
  std::optional<Time> until;             ///< length of the recording from its start
  std::optional<Trigger> start;          ///< nothing: it starts with the first image
  std::optional<Trigger> stop;           ///< ends it, with the image in which it holds
  Time before = 0;                       ///< what is kept from before the start condition holds
  std::uint64_t model_hash = 0;          ///< of the plant
  std::function<std::string(Time)> utc;  ///< a time of the steady clock as ISO 8601
};

/// How far a recording is, or what it has.
struct RecordState {
  bool has_images = false;
  bool has_started = false;
  bool is_lost = false;  ///< the connection, now
  Time kept = 0;         ///< of the length, the part before the start condition held
  Time length = 0;
  std::uint64_t symbols = 0;  ///< that were read
  std::uint64_t changes = 0;  ///< without the first values
  std::uint64_t gaps = 0;
  Time gap_time = 0;    ///< of all gaps together
  Time resolution = 0;  ///< the interval of readings that was reached
};

/// Takes images one after the other. It has no thread and no clock. A time between two images of more than three
/// intervals is a gap, as is each loss of the connection; the interval of a slow PLC is the median of the last images.
/// The file gets a line with the interval if the PLC is slower than wanted, as a killed process writes no end.
class Writer {
 public:
  /// `file` is open; what it has is replaced at the start. Names must outlive it.
  Writer(trace::OutputFile file, const trace::PlantNames& names, What what);

  void take(const Batch& batch);
  /// The connection is lost.
  void lost() { state_.is_lost = true; }
  /// To be called from time to time, also without images: ends the recording at its length.
  void look(Time now);
  /// Ends it: the last lines. `now`: the time of the end, for a connection that is lost.
  void finish(Time now);
  /// Passes what was written to the system.
  void flush();

  /// No more images are needed: the length is reached, the stop condition held, or the file cannot be written.
  bool has_ended() const { return ended_ || !error().empty(); }
  const RecordState& state() const { return state_; }
  const std::string& error() const { return trace_ ? trace_->error() : file_->error(); }
  /// For the user, once.
  std::string take_message() { return std::exchange(message_, {}); }

 private:
  std::optional<Line> gap_before(const Batch& batch);
  bool is_gap(Time distance) const;
  void note_interval();
  void wait_for_start(const Batch& batch, const std::optional<Line>& gap);
  void start(Time begin, Time now);
  void write_kept();
  void write(const Line& line, bool is_first);
  void end(Time time);

  const trace::PlantNames& names_;
  What what_;
  std::optional<trace::OutputFile> file_;  ///< until the start
  std::optional<trace::TraceFile> trace_;  ///< from then on
  trace::History history_;
  KeptPart kept_;
  std::vector<std::uint64_t> values_;  ///< by symbol
  std::vector<bool> known_;
  Time zero_ = 0;     ///< t = 0
  Time latest_ = -1;  ///< the time of the latest image; -1: there was none
  Time begun_ = -1;   ///< the first time of the latest image
  Interval interval_;
  std::uint64_t note_at_ = 20;  ///< images; then twice as many each time
  Time end_ = tables::kNever;
  Time last_line_ = 0;
  bool ended_ = false;
  std::string message_;
  RecordState state_;
};

}  // namespace symplant::record
