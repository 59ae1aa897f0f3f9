// The malfunctions as JSON: the keys are those of plant.json, with resolved names and nanoseconds.
#include "elements/malfunction/json.hpp"

#include <optional>
#include <string_view>

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
    write_effect(malfunction);
    condition("when", malfunction.condition);
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
  void write_effect(const Malfunction& malfunction) {
    switch (malfunction.kind) {
      case tables::MalfunctionKind::slower:
        units(malfunction);
        return json_.member("slower", malfunction.factor / 1000.0);
      case tables::MalfunctionKind::stuck:
        units(malfunction);
        return write_stuck(malfunction);
      case tables::MalfunctionKind::force:
        json_.key("force");
        json_.begin_object();
        for (const tables::MalfunctionForce& force : malfunction.forces) {
          const model::Symbol& symbol = plant_.symbols[force.symbol];
          json_.key(symbol.name());
          write_value(symbol.type, force.value, json_);
        }
        return json_.end_object();
      case tables::MalfunctionKind::flicker:
        json_.key("flicker");
        json_.begin_object();
        json_.member("symbol", plant_.symbols[malfunction.subject].name());
        time("every", malfunction.every);
        json_.member("for", malfunction.shows);
        return json_.end_object();
      case tables::MalfunctionKind::lose:
        return write_lose(plant_.controllers[malfunction.subject]);
    }
  }

  void units(const Malfunction& malfunction) {
    json_.key("of");
    json_.array(malfunction.units,
                [&](const tables::MalfunctionUnit& each) { json_.value(plant_.units[each.unit].path); });
  }

  void write_stuck(const Malfunction& malfunction) {
    const bool in_a_state = !malfunction.units.empty() && malfunction.units.front().state != tables::kNoState;
    if (!in_a_state) return json_.member("stuck", true);
    const tables::MalfunctionUnit& first = malfunction.units.front();
    json_.member("stuck", plant_.units[first.unit].states[first.state].name);
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
