// Checks the names in the plan and the 3D view of the panel.
#include "elements/scene/resolve.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "model/layout.hpp"

namespace symplant::model {
namespace {

using description::FaultKind;
using description::SceneName;
using description::ticked;
using Kind = SceneName::Kind;

constexpr std::size_t kKinds = 5;

/// Names of one kind, as the panel writes them: compared exactly.
class KnownNames {
 public:
  void add(std::string_view name) { all_.push_back(name); }
  bool has(std::string_view name) {
    if (set_.empty()) set_.insert(all_.begin(), all_.end());
    return set_.contains(name);
  }
  std::string_view nearest(std::string_view name, const description::Faults& faults) const {
    return faults.nearest(name, all_.size(), [&](std::size_t i) { return all_[i]; });
  }

 private:
  std::vector<std::string_view> all_;
  std::unordered_set<std::string_view> set_;
};

class SceneChecker {
 public:
  SceneChecker(const PlantModel& plant, description::Faults& faults)
      : plant_(plant), faults_(faults), stations_(layout_of(plant).stations) {
    for (std::uint32_t unit = 0; unit < plant.units.size(); ++unit) {
      units_.emplace(plant.units[unit].path, unit);
      of(Kind::device).add(plant.units[unit].path);
    }
    for (std::uint32_t i = 0; i < plant.material.locations(); ++i)
      of(Kind::location).add(plant.material.location_name(i));
    for (const Value& value : plant.values) of(Kind::number).add(value.name);
    for (const Symbol& symbol : plant.symbols) {
      if (symbol.type != tables::DataType::boolean) of(Kind::number).add(symbol.name());
    }
    frames_.reserve(stations_.size());
    for (const Station& station : stations_) {
      const std::string_view between = station.line.empty() || station.process.empty() ? "" : " ";
      frames_.push_back(std::string(station.line).append(between).append(station.process));
    }
    for (const std::string& frame : frames_) of(Kind::frame).add(frame);
    for (const std::string& group : plant.description->scene.groups) of(Kind::frame).add(group);
  }

  void run() {
    for (const SceneName& name : plant_.description->scene.names) {
      name.kind == Kind::posed ? check_pose(name) : check(name, name.kind);
    }
  }

 private:
  KnownNames& of(Kind kind) { return known_[static_cast<std::size_t>(kind)]; }

  void check(const SceneName& name, Kind kind) {
    static constexpr std::array<std::string_view, kKinds> kWords{"device", "track or place", "station or group",
                                                                 "device", "value or numeric symbol"};
    if (of(kind).has(name.name)) return;
    report(name, std::string(kWords[static_cast<std::size_t>(kind)]) + " " + ticked(name.name),
           of(kind).nearest(name.name, faults_));
  }

  /// A key of a node that is the state of a device.
  void check_pose(const SceneName& name) {
    const auto unit = units_.find(name.name);
    if (unit == units_.end()) return check(name, Kind::device);
    const std::vector<State>& states = plant_.units[unit->second].states;
    if (std::any_of(states.begin(), states.end(), [&](const State& state) { return state.name == name.state; })) return;
    report(
        name, "state " + ticked(name.state) + " of " + ticked(name.name),
        faults_.nearest(name.state, states.size(), [&](std::size_t i) -> std::string_view { return states[i].name; }));
  }

  void report(const SceneName& name, const std::string& what, std::string_view nearest) {
    description::DescriptionFault fault{name.pointer, description::missing(what, nearest), 0, FaultKind::unknown_name};
    fault.at_key = name.kind != Kind::number;
    faults_.add(std::move(fault));
  }

  const PlantModel& plant_;
  description::Faults& faults_;
  const std::vector<Station> stations_;
  std::vector<std::string> frames_;
  std::array<KnownNames, kKinds> known_;
  std::unordered_map<std::string_view, std::uint32_t> units_;
};

}  // namespace

void check_scene(const PlantModel& plant, description::Faults& faults) {
  if (!plant.description->scene.names.empty()) SceneChecker(plant, faults).run();
}

}  // namespace symplant::model
