// SP631 track-never-moves: no drive of a track can ever move.
#include <fmt/format.h>

#include <algorithm>

#include "check/part_routes.hpp"
#include "check/reachability/reach.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTrackNeverMovesPage =
    R"(No drive of the track has a condition that can ever hold: none is given, they contradict themselves, or they name a state that
nothing leads to.

**What the model loses.** Parts that come to the track stay where they arrive.

**How to fix it.** Write `forward` or `backward` with the state or the operation of the motor that moves this track.
)";

void check_track_never_moves(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.material.tracks.empty() || !subject.evidence.faults.empty()) return;
  const Reach reach(plant);
  const auto may_hold = [&](const std::optional<condition::Tree>& tree) {
    return tree && !decide(*tree, plant, reach).never();
  };
  for (const model::Track& track : plant.material.tracks) {
    if (std::any_of(track.drives.begin(), track.drives.end(),
                    [&](const model::Drive& drive) { return may_hold(drive.forward) || may_hold(drive.backward); })) {
      continue;
    }
    diagnostics.add(rule.info, {},
                    fmt::format("track `{}` never moves: no condition of its drives can hold", track.name),
                    location_of({}, track_pointer(plant, track) / "drives"));
  }
}

}  // namespace

const Rule kTrackNeverMoves{
    {"SP631", "track-never-moves", diag::Severity::warning, "no drive of a track can ever move", kTrackNeverMovesPage},
    check_track_never_moves};

}  // namespace symplant::check
