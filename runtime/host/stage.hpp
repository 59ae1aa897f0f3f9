// A plant ready to run: with its scenario player, recorder, report and outputs.
#pragma once

#include <algorithm>
#include <optional>
#include <ostream>

#include "symplant/host/console.hpp"
#include "symplant/host/fault_start.hpp"
#include "symplant/host/outputs.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/host/report.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/program/lock_step.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/snapshot_file.hpp"

namespace symplant::host {

/// The streams of a run.
struct RunStreams {
  std::ostream& out;  ///< standard output, for files with the path `-`
  std::ostream& err;
  std::ostream& report;  ///< for the texts of the run: `out`, or `err` if a file goes to `out`
  Console& console;      ///< writes to `report` and `err`
};

/// All parts of a run except its links. The arguments of the constructor must outlive it. Its members refer to each
/// other, so it cannot be copied or moved.
class Stage {
 public:
  /// `scenario` may be null.
  Stage(const PlantProgram& program, const RunOptions& options, const trace::PlantNames& names,
        const scenario::Scenario* scenario, bool real_time, const RunStreams& streams);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Sets the plant to a saved state of its model; false if it does not fit. To be called before the first instant.
  bool resume(const trace::Snapshot& snapshot);
  /// The stepper that advances the plant; null if the plant advances alone. `driver` replaces the scenario's player; it
  /// may be null.
  exec::Stepper* stepper(exec::Stepper* driver) noexcept {
    if (driver == nullptr && player) driver = &*player;
    if (fault) {
      fault->drive(driver);
      driver = &*fault;
    }
    if (!programs) return driver;
    programs->drive(driver);
    return &*programs;
  }
  /// Runs every instant before `time`, then the one at `time`, with the steps of the scenario and the scans of
  /// programs.
  void advance_to(tables::Time time) noexcept {
    programs ? programs->advance_to(time) : advance_without_programs(time);
  }
  /// Starts a malfunction at a time. To be called before the first instant.
  void start_fault(std::uint32_t number, tables::Time at);
  /// The same without programs, which begin with the first call of advance_to().
  void advance_without_programs(tables::Time time) noexcept {
    if (fault) {
      fault->advance_to(time);
    } else if (player) {
      player->advance_to(time);
    } else {
      plant.advance_to(time, &recorder);
    }
  }
  /// Time of the next event of the plant, step of the scenario or scan of a program; kNever if there is nothing more.
  tables::Time next_due() const noexcept {
    tables::Time due = player ? std::min(plant.next_due(), player->next()) : plant.next_due();
    if (fault) due = std::min(due, fault->next());
    return programs ? std::min(due, programs->next_due()) : due;
  }

  plant::OwnedPlant plant;
  trace::Recorder recorder;
  trace::History history;
  why::Explainer explainer;
  Report report;
  Outputs outputs;
  std::optional<scenario::Player> player;     ///< only with a scenario
  std::optional<FaultStart> fault;            ///< only with --fault
  std::optional<program::LockStep> programs;  ///< only with PLC programs
};

}  // namespace symplant::host
