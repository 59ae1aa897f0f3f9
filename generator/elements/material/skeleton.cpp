// Proposes a material flow for a list.
#include "elements/material/skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "elements/material/part_words.hpp"
#include "model/condition_text.hpp"
#include "text/ascii.hpp"

namespace symplant::emit {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostTracks = 8;
constexpr std::size_t kMostSensors = 8;       ///< on a track
constexpr std::size_t kSensorDistance = 500;  ///< mm

bool is_candidate(const model::PlantModel& plant, const model::Symbol& symbol) {
  return symbol.direction == tables::Direction::event && symbol.type == tables::DataType::boolean &&
         symbol.reading.is_named() && !model::is_driven(plant, symbol) && model::looks_like_part_sensor(symbol);
}

/// A state that a motor of the process is commanded to, as a condition; empty if none is named like one.
std::string running(const model::PlantModel& plant, std::string_view line, std::string_view process) {
  static constexpr std::array<std::string_view, 4> kRunning{"RUN", "FWD", "FORWARD", "MOVE"};
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const model::Unit& unit = plant.units[u];
    if (unit.operations.empty()) continue;
    const model::SymbolReading& reading = plant.symbols[unit.operations.front()].reading;
    if (reading.line() != line || reading.process() != process) continue;
    for (std::size_t s = 0; s < unit.states.size(); ++s) {
      const bool named = std::any_of(kRunning.begin(), kRunning.end(), [&](std::string_view word) {
        return text::equal_ignoring_case(unit.states[s].name, word);
      });
      if (!named || unit.states[s].operation == model::kNone) continue;
      condition::Tree tree;
      tree.kind = condition::Tree::Kind::atom;
      tree.atom = {condition::Atom::Kind::settled, u, static_cast<std::uint8_t>(s)};
      return model::condition_text(tree, plant);
    }
  }
  return {};
}

}  // namespace

bool is_only_part_sensors(const model::PlantModel& plant, const model::Unit& unit) {
  return unit.operations.empty() && std::all_of(unit.events.begin(), unit.events.end(), [&](std::uint32_t event) {
           return is_candidate(plant, plant.symbols[event]);
         });
}

Json proposed_material(const model::PlantModel& plant) {
  if (!plant.material.empty()) return nullptr;
  std::vector<std::pair<std::string_view, std::string_view>> stations;  // line and process, in the order of the list
  std::map<std::pair<std::string_view, std::string_view>, std::vector<std::string_view>> sensors;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!is_candidate(plant, symbol)) continue;
    const std::pair station{symbol.reading.line(), symbol.reading.process()};
    std::vector<std::string_view>& names = sensors[station];
    if (names.empty()) stations.push_back(station);
    names.push_back(symbol.name());
  }
  if (stations.empty()) return nullptr;
  Json tracks = Json::object();
  for (std::size_t i = 0; i < stations.size() && i < kMostTracks; ++i) {
    const auto& [line, process] = stations[i];
    const std::string name = fmt::format("TRACK_{}_{}", line, process);
    const std::vector<std::string_view>& names = sensors[stations[i]];
    Json list = Json::array();
    for (std::size_t s = 0; s < names.size() && s < kMostSensors; ++s) {
      list.push_back({{"symbol", names[s]}, {"at", fmt::format("{} mm", kSensorDistance * (s + 1))}});
    }
    std::string motor = running(plant, line, process);
    if (motor.empty()) motor = name + ".part";
    tracks[name] = {{"length", fmt::format("{} mm", kSensorDistance * (list.size() + 1))},
                    {"drives", Json::array({{{"forward", motor}, {"speed", "0.2 m/s"}}})},
                    {"sensors", list},
                    {"end", "out"}};
  }
  const std::string first = tracks.begin().key();
  return {{"kinds", {{"box", {{"length", "200 mm"}}}}},
          {"tracks", tracks},
          {"sources", Json::array({{{"name", "infeed"}, {"at", first}, {"kind", "box"}, {"every", "10s"}}})}};
}

}  // namespace symplant::emit
