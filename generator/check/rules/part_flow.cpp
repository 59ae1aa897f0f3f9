// Rules: `material` of plant.json.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "check/part_routes.hpp"
#include "check/reachability/reach.hpp"
#include "check/rules.hpp"
#include "model/part_words.hpp"

namespace symplant::check {
namespace {

void check_part_sensor_not_described(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.material.empty()) return;
  constexpr std::size_t kMostNamed = 3;
  std::vector<const model::Symbol*> found;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.direction != tables::Direction::event) continue;
    if (model::is_driven(plant, symbol) || !model::looks_like_part_sensor(symbol)) continue;
    found.push_back(&symbol);
  }
  if (found.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < found.size() && i < kMostNamed; ++i) {
    names += fmt::format("{}`{}`", i == 0 ? "" : ", ", found[i]->name());
  }
  if (found.size() > kMostNamed) names += fmt::format(" and {} more", found.size() - kMostNamed);
  diag::Subjects subjects = about(*found.front());
  for (const model::Symbol* symbol : found) {
    if (symbol->unit != model::kNone)
      subjects = std::move(subjects).explaining(model_of(plant.units[symbol->unit].path));
  }
  diagnostics.add(
      rule.info, std::move(subjects),
      fmt::format("{} {} like {}, but no part drives {}: add {} to `sensors` of a track or place", names,
                  found.size() == 1 ? "looks" : "look", found.size() == 1 ? "a sensor of parts" : "sensors of parts",
                  found.size() == 1 ? "it" : "them", found.size() == 1 ? "it" : "them"),
      location_of(plant, *found.front()));
}

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

void check_transfer_without_parts(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const model::Material& material = plant.material;
  if (material.sources.empty() || !subject.evidence.faults.empty()) return;
  const std::vector<bool> reached = locations_with_parts(material);
  for (const model::Transfer& transfer : material.transfers) {
    if (reached[transfer.from.location]) continue;
    diagnostics.add(
        rule.info, {},
        fmt::format("transfer `{}`: no part can come to `{}`; add what brings parts there", transfer.name,
                    material.location_name(transfer.from.location)),
        location_of({}, description::Pointer("/material/transfers") / std::size_t{transfer.given} / "from"));
  }
}

void check_parts_never_leave(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const model::Material& material = plant.material;
  if (material.empty() || !subject.evidence.faults.empty()) return;
  const std::vector<bool> reached = locations_with_parts(material);
  for (std::uint32_t location = 0; location < reached.size(); ++location) {
    if (!reached[location] || (material.is_track(location) && !material.tracks[location].ends.empty())) continue;
    if (std::any_of(material.transfers.begin(), material.transfers.end(),
                    [&](const model::Transfer& transfer) { return transfer.from.location == location; })) {
      continue;
    }
    const bool track = material.is_track(location);
    diagnostics.add(
        rule.info, {},
        fmt::format("parts never leave {} `{}`: {}", track ? "track" : "place", material.location_name(location),
                    track ? "add `end`, or a transfer that takes them" : "add a transfer that takes them"),
        location_of({}, track ? track_pointer(plant, material.tracks[location])
                              : place_pointer(plant, material.places[location - material.tracks.size()])));
  }
}

}  // namespace

const Rule kPartSensorNotDescribed{
    {"SP630", "part-sensor-not-described", diag::Severity::warning,
     "an input that looks like a sensor of parts is not in `material`",
     R"(The plant has a material flow, and inputs that look like photo-eyes, presence or pallet sensors by their names, but no sensor of
`material` drives them, and nothing else does.

**What the model loses.** These inputs never change. A program that waits for a part there waits forever.

**How to fix it.** Add them to `sensors` of a track or place, or let them follow a condition (`follow`). If they sense no parts, ignore
this finding in plant.json with a `why`.
)"},
    check_part_sensor_not_described};

const Rule kTrackNeverMoves{
    {"SP631", "track-never-moves", diag::Severity::warning, "no drive of a track can ever move",
     R"(No drive of the track has a condition that can ever hold: none is given, they contradict themselves, or they name a state that
nothing leads to.

**What the model loses.** Parts that come to the track stay where they arrive.

**How to fix it.** Write `forward` or `backward` with the state or the operation of the motor that moves this track.
)"},
    check_track_never_moves};

const Rule kTransferWithoutParts{
    {"SP632", "transfer-without-parts", diag::Severity::warning,
     "no part can reach the location that a transfer takes from",
     R"(The material flow has sources, but from none of them a part can come to the location that this transfer takes parts from: no end of
a track and no other transfer leads there.

**What the model loses.** The transfer never moves a part, unless a scenario or a person puts one there.

**How to fix it.** Name the right location in `from`, or add the `end`, transfer or source that brings parts there.
)"},
    check_transfer_without_parts};

const Rule kPartsNeverLeave{
    {"SP633", "parts-never-leave", diag::Severity::note, "parts come to a track or place and nothing takes them away",
     R"(Parts can come to this track or place, but a track without `end` and a place keep them, and no transfer takes parts from there.

**What the model loses.** Parts collect there until there is no room, and what brings them waits. This may be what you want: a floor
that must stay empty, a box of rejects.

**How to fix it.** Add `end` to the track (`"end": "out"` lets parts leave the plant), or a transfer that takes parts from there.
)"},
    check_parts_never_leave};

}  // namespace symplant::check
