// Small single edits of material flow.
#include <algorithm>
#include <functional>

#include "property/simpler.hpp"

namespace symplant::property {
namespace {

using description::GivenMaterial;

bool names_location(const std::string& condition, const std::string& name) {
  return condition.find(name + ".") != condition.npos;
}

bool is_at(const std::string& spot, const std::string& name) { return spot.substr(0, spot.find('@')) == name; }

template <class Visit>
void each_sensor(GivenMaterial& material, Visit visit) {
  for (description::GivenTrack& track : material.tracks) {
    for (description::GivenSensor& given : track.sensors) visit(given);
  }
  for (description::GivenPlace& place : material.places) {
    for (description::GivenSensor& given : place.sensors) visit(given);
  }
}

std::size_t sensors_size(const std::vector<description::GivenSensor>& sensors) {
  std::size_t size = 0;
  for (const description::GivenSensor& given : sensors) {
    size += 5 + given.kinds.size() + (given.inverted ? 1 : 0) + (given.reads == tables::SensorReads::part ? 0 : 1);
  }
  return size;
}

}  // namespace

std::size_t material_size(const GivenMaterial& material) {
  std::size_t size = 10 * (material.kinds.size() + material.places.size());
  for (const description::GivenTrack& track : material.tracks) {
    size += 10 + (track.gap == 0 ? 0 : 1) + sensors_size(track.sensors) + 5 * track.drives.size();
    for (const description::GivenDrive& given : track.drives) {
      size += given.forward.size() + given.backward.size() + (given.speed.of.empty() ? 0 : 1);
    }
    for (const description::GivenStop& given : track.stops) size += 5 + given.when.size();
    for (const description::GivenEnd& given : track.ends) size += 5 + given.when.size();
  }
  for (const description::GivenPlace& place : material.places) {
    size += sensors_size(place.sensors) + (place.holds == 1 ? 0 : 1);
  }
  for (const auto& given : material.transfers) size += 5 + given.when.size() + (given.once ? 1 : 0);
  for (const auto& given : material.work) size += 5 + given.when.size();
  for (const description::GivenSource& given : material.sources) {
    const bool random = given.every && given.every->kind != description::Duration::Kind::fixed;
    size += 5 + given.when.size() + given.kinds.size() + (given.count ? 1 : 0) + (given.first == 0 ? 0 : 1) +
            (random        ? 2
             : given.every ? 1
                           : 0);
  }
  return size;
}

std::vector<std::string> part_locations(const PlantText& plant) {
  std::vector<std::string> names;
  for (const description::GivenTrack& track : plant.description.material.tracks) names.push_back(track.name);
  for (const description::GivenPlace& place : plant.description.material.places) names.push_back(place.name);
  return names;
}

void remove_location(PlantText& plant, const std::string& name) {
  GivenMaterial& material = plant.description.material;
  const auto named = [&](const auto& given) { return given.name == name; };
  const auto reads_it = [&](const auto& given) { return names_location(given.when, name); };
  std::erase_if(material.tracks, named);
  std::erase_if(material.places, named);
  for (description::GivenTrack& track : material.tracks) {
    std::erase_if(track.ends, [&](const auto& given) { return given.to == name || reads_it(given); });
    std::erase_if(track.stops, reads_it);
    for (description::GivenDrive& given : track.drives) {
      if (names_location(given.forward, name)) given.forward.clear();
      if (names_location(given.backward, name)) given.backward.clear();
    }
  }
  std::erase_if(material.transfers,
                [&](const auto& given) { return is_at(given.from, name) || is_at(given.to, name) || reads_it(given); });
  std::erase_if(material.work, [&](const auto& given) { return is_at(given.at, name) || reads_it(given); });
  std::erase_if(material.sources, [&](const auto& given) { return is_at(given.at, name) || reads_it(given); });
}

void each_condition(GivenMaterial& material, const std::function<void(std::string&, bool)>& visit) {
  for (description::GivenTrack& track : material.tracks) {
    for (description::GivenDrive& given : track.drives) {
      visit(given.forward, true);
      visit(given.backward, true);
    }
    for (description::GivenStop& given : track.stops) visit(given.when, false);
    for (description::GivenEnd& given : track.ends) visit(given.when, true);
  }
  for (description::GivenTransfer& given : material.transfers) visit(given.when, true);
  for (description::GivenWork& given : material.work) visit(given.when, false);
  for (description::GivenSource& given : material.sources) visit(given.when, true);
}

void each_edit(GivenMaterial& material, const std::function<void(const std::function<void()>&)>& visit) {
  for (description::GivenTrack& track : material.tracks) {
    if (track.gap != 0) visit([&] { track.gap = 0; });
    for (description::GivenDrive& given : track.drives) {
      if (!given.speed.of.empty()) visit([&] { given.speed.of.clear(); });
    }
  }
  each_sensor(material, [&](description::GivenSensor& given) {
    if (!given.kinds.empty()) visit([&] { given.kinds.clear(); });
    if (given.inverted) visit([&] { given.inverted = false; });
  });
  for (description::GivenPlace& place : material.places) {
    if (place.holds != 1) visit([&] { place.holds = 1; });
  }
  for (description::GivenTransfer& given : material.transfers) {
    if (given.once) visit([&] { given.once = false; });
  }
  for (description::GivenSource& given : material.sources) {
    if (given.kinds.size() > 1) visit([&] { given.kinds.resize(1); });
    if (given.count) visit([&] { given.count.reset(); });
    if (given.first != 0) visit([&] { given.first = 0; });
    if (given.every && given.every->kind != description::Duration::Kind::fixed) {
      visit([&] { given.every = description::Duration::fixed(10 * tables::kMillisecond); });
    }
    if (given.every) visit([&] { given.every.reset(); });
  }
}

}  // namespace symplant::property
