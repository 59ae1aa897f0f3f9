// The files that a run writes while the plant runs.
#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <thread>

#include "symplant/core/plant.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/trace_file.hpp"

namespace symplant::host {

/// What is recorded of a run and where it goes: a recorder in the cycle, files outside it. Costs nothing where no file
/// is asked for.
class Outputs {
 public:
  /// `tables` and `options` must outlive it.
  Outputs(const core::PlantTables& tables, const RunOptions& options);

  /// To be called before the plant is advanced.
  void attach(const core::Plant& plant) { recorder_.attach(plant); }
  /// Opens the files; what was recorded before goes into them, too. False where one cannot be, which is told on `err`.
  bool open(std::uint64_t model_hash, std::ostream& err);

  /// What the plant is to be advanced with; null where nobody looks.
  core::Observer* observer() { return options_.trace.empty() ? nullptr : &recorder_; }

  /// Writes what was recorded; in virtual time, after each instant.
  void drain();

  /// In real time a thread writes, so that the cycle never waits for a disk.
  void start_thread();
  void stop_thread();

  /// Writes the rest, and tells on `err` what is missing.
  void finish(std::ostream& err);

 private:
  const core::PlantTables& tables_;
  const RunOptions& options_;
  trace::Recorder recorder_;
  std::unique_ptr<trace::TraceFile> trace_;
  std::jthread thread_;
};

}  // namespace symplant::host
