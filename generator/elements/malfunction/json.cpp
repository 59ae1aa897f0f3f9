// The malfunctions as JSON: the keys are those of plant.json, with resolved names and nanoseconds.
#include "elements/malfunction/json.hpp"

#include <optional>
#include <string_view>
#include <vector>

#include "model/condition_text.hpp"
#include "view/duration_json.hpp"
#include "view/value_json.hpp"

namespace symplant::view {
namespace {

using model::kNone;
using model::Malfunction;

class MalfunctionWriter {
 public:
  MalfunctionWriter(const model::PlantModel& plant, JsonWriter& json) : plant_(plant), json_(json) {}

  void write(const Malfunction& malfunction) {
    json_.begin_object();
    json_.member("name", malfunction.name);
    if (malfunction.effects.size() == 1) {
      write_effect(malfunction.effects.front());
    } else {
      json_.key("effects");
      json_.array(malfunction.effects, [&](const model::Effect& effect) {
        json_.begin_object();
        write_effect(effect);
        json_.end_object();
      });
    }
    condition(malfunction.during ? "while" : "when", malfunction.condition);
    time("chance", malfunction.chance);
    time("lasts", malfunction.lasts);
    if (malfunction.next != kNone) {
      json_.key("becomes");
      json_.begin_object();
      json_.member("after", malfunction.after);
      condition("unless", malfunction.unless);
      json_.member("start", plant_.malfunctions[malfunction.next].name);
      json_.end_object();
    }
    json_.end_object();
  }

 private:
  void write_effect(const model::Effect& effect) {
    switch (effect.kind) {
      case tables::MalfunctionKind::slower:
        devices(effect);
        return json_.member("slower", effect.factor / 1000.0);
      case tables::MalfunctionKind::stuck:
        devices(effect);
        return write_stuck(effect);
      case tables::MalfunctionKind::force:
        json_.key("force");
        json_.begin_object();
        for (const tables::MalfunctionForce& force : effect.forces) {
          const model::Symbol& symbol = plant_.symbols[force.symbol];
          if (force.holds) {
            json_.member(symbol.name(), "hold");
            continue;
          }
          json_.key(symbol.name());
          write_value(symbol.type, force.value, json_);
        }
        return json_.end_object();
      case tables::MalfunctionKind::flicker:
        json_.key("flicker");
        json_.begin_object();
        json_.member("symbol", plant_.symbols[effect.subject].name());
        time("every", effect.every);
        json_.member("for", effect.shows);
        return json_.end_object();
      case tables::MalfunctionKind::lose:
        return write_lose(plant_.controllers[effect.subject]);
      case tables::MalfunctionKind::set:
        json_.key("set");
        json_.begin_object();
        for (const tables::MalfunctionSet& set : effect.sets) {
          json_.member(plant_.values[set.value].name, set.number);
        }
        return json_.end_object();
      case tables::MalfunctionKind::distort:
        return write_distort(effect);
    }
  }

  /// Devices, then tracks.
  void devices(const model::Effect& effect) {
    std::vector<std::string_view> names;
    for (const tables::MalfunctionUnit& each : effect.units) names.push_back(plant_.units[each.unit].path);
    for (const std::uint32_t track : effect.tracks) names.push_back(plant_.material.tracks[track].name);
    json_.key("of");
    json_.array(names, [&](std::string_view name) { json_.value(name); });
  }

  void write_stuck(const model::Effect& effect) {
    const bool in_a_state = !effect.units.empty() && effect.units.front().state != tables::kNoState;
    if (!in_a_state) return json_.member("stuck", true);
    const tables::MalfunctionUnit& first = effect.units.front();
    json_.member("stuck", plant_.units[first.unit].states[first.state].name);
  }

  void write_distort(const model::Effect& effect) {
    json_.key("distort");
    json_.begin_object();
    json_.member("symbol", plant_.symbols[plant_.signals[effect.subject].row.symbol].name());
    json_.member("gain", effect.distort.gain);
    json_.member("offset", effect.distort.offset);
    json_.member("drift", effect.distort.drift);
    json_.end_object();
  }

  void write_lose(const std::string& controller) {
    if (controller.empty()) return json_.member("lose", true);
    json_.member("lose", controller);
  }

  void condition(std::string_view key, const std::optional<condition::Tree>& tree) {
    if (tree) json_.member(key, model::condition_text(*tree, plant_));
  }

  void time(std::string_view key, const std::optional<description::Duration>& time) {
    if (!time) return;
    json_.key(key);
    write_time(*time, json_);
  }

  const model::PlantModel& plant_;
  JsonWriter& json_;
};

}  // namespace

void write_malfunctions(const model::PlantModel& plant, JsonWriter& json) {
  if (plant.malfunctions.empty()) return;
  json.key("malfunctions");
  json.array(plant.malfunctions,
             [&](const Malfunction& malfunction) { MalfunctionWriter(plant, json).write(malfunction); });
}

}  // namespace symplant::view
