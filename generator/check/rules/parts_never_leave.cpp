// SP633 parts-never-leave: parts come to a track or place and nothing takes them away.
#include <fmt/format.h>

#include <algorithm>

#include "check/part_routes.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPartsNeverLeavePage =
    R"(Parts can come to this track or place, but a track without `end` and a place keep them, and no transfer takes parts from there.

**What the model loses.** Parts collect there until there is no room, and what brings them waits. This may be what you want: a floor
that must stay empty, a box of rejects.

**How to fix it.** Add `end` to the track (`"end": "out"` lets parts leave the plant), or a transfer that takes parts from there.
)";

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

const Rule kPartsNeverLeave{{"SP633", "parts-never-leave", diag::Severity::note,
                             "parts come to a track or place and nothing takes them away", kPartsNeverLeavePage},
                            check_parts_never_leave};

}  // namespace symplant::check
