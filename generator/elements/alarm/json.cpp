// The alarms as JSON, for programs.
#include "elements/alarm/json.hpp"

namespace symplant::view {

void write_alarms(const model::PlantModel& plant, JsonWriter& json) {
  if (plant.alarms.empty()) return;
  json.key("alarms");
  json.array(plant.alarms, [&](const model::Alarm& alarm) {
    alarm.symbol != model::kNone ? json.value(plant.symbols[alarm.symbol].name())
                                 : json.value(plant.values[alarm.value].name);
  });
}

}  // namespace symplant::view
