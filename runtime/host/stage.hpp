// A plant ready to run: with who acts on it, who looks at it, and where that goes.
#pragma once

#include <algorithm>
#include <optional>

#include "symplant/host/outputs.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/host/report.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::host {

/// All parts of a run but its links. Refers to what it is made of. Its members refer to each other, so it stays where
/// it is.
class Stage {
 public:
  /// `scenario` may be null. `out` is standard output, for files that go there.
  Stage(const PlantProgram& program, const RunOptions& options, const trace::PlantNames& names,
        const scenario::Scenario* scenario, bool real_time, std::ostream& out, Console& console);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Every instant before `time`, then the one at `time`, with what the scenario does.
  void advance_to(tables::Time time) noexcept {
    if (player) {
      player->advance_to(time);
    } else {
      plant.advance_to(time, &recorder);
    }
  }
  /// When something is due next, by the plant or the scenario; kNever where nothing is.
  tables::Time next_due() const noexcept {
    return player ? std::min(plant.next_due(), player->next()) : plant.next_due();
  }

  plant::OwnedPlant plant;
  trace::Recorder recorder;
  trace::History history;
  Report report;
  Outputs outputs;
  std::optional<scenario::Player> player;  ///< where a scenario is played
};

}  // namespace symplant::host
