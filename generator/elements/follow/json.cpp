// The symbols that follow a condition as JSON, for programs.
#include "elements/follow/json.hpp"

#include "model/condition_text.hpp"

namespace symplant::view {

void write_follows(const model::PlantModel& plant, JsonWriter& json) {
  json.key("follow");
  json.array(plant.follows, [&](const model::Follow& follow) {
    json.begin_object();
    json.member("symbol", plant.symbols[follow.symbol].name());
    json.member("condition", model::condition_text(follow.condition, plant));
    if (follow.off) json.member("off", model::condition_text(*follow.off, plant));
    json.end_object();
  });
}

}  // namespace symplant::view
