// Where parts can come in a material flow.
#include "check/part_routes.hpp"

namespace symplant::check {

std::vector<bool> locations_with_parts(const model::Material& material) {
  const std::size_t locations = material.locations();
  std::vector<std::vector<std::uint32_t>> next(locations);
  for (std::uint32_t track = 0; track < material.tracks.size(); ++track) {
    for (const model::TrackEnd& end : material.tracks[track].ends) {
      if (end.to != tables::kOut) next[track].push_back(end.to);
    }
  }
  for (const model::Transfer& transfer : material.transfers) {
    if (transfer.to.location != tables::kOut) next[transfer.from.location].push_back(transfer.to.location);
  }
  std::vector<bool> reached(locations);
  std::vector<std::uint32_t> open;
  const auto reach = [&](std::uint32_t location) {
    if (reached[location]) return;
    reached[location] = true;
    open.push_back(location);
  };
  for (const model::Source& source : material.sources) reach(source.to.location);
  while (!open.empty()) {
    const std::uint32_t location = open.back();
    open.pop_back();
    for (const std::uint32_t to : next[location]) reach(to);
  }
  return reached;
}

description::Pointer track_pointer(const model::PlantModel& plant, const model::Track& track) {
  return description::Pointer("/material/tracks") /
         std::string_view(plant.description->material.tracks[track.given].name);
}

description::Pointer place_pointer(const model::PlantModel& plant, const model::Place& place) {
  return description::Pointer("/material/places") /
         std::string_view(plant.description->material.places[place.given].name);
}

}  // namespace symplant::check
