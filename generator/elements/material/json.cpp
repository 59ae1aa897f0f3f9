// The material flow as JSON: the keys are those of plant.json, with resolved names and whole numbers.
#include "elements/material/json.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/condition_text.hpp"
#include "view/duration_json.hpp"

namespace symplant::view {
namespace {

class MaterialWriter {
 public:
  MaterialWriter(const model::PlantModel& plant, JsonWriter& json)
      : plant_(plant), material_(plant.material), json_(json) {}

  void write() {
    json_.begin_object();
    objects("kinds", material_.kinds, [&](const model::PartKind& kind) {
      json_.member("name", kind.name);
      json_.member("length", kind.length);
      json_.member("code", kind.code);
      if (kind.weight != 0) json_.member("weight", kind.weight);
    });
    objects("tracks", material_.tracks, [&](const model::Track& track) { write_track(track); });
    objects("places", material_.places, [&](const model::Place& place) {
      json_.member("name", place.name);
      json_.member("holds", place.holds);
      objects("sensors", place.sensors, [&](const model::PartSensor& sensor) { write_sensor(sensor, false); });
    });
    objects("transfers", material_.transfers, [&](const model::Transfer& transfer) {
      json_.member("name", transfer.name);
      location("from", transfer.from);
      location("to", transfer.to);
      condition("when", transfer.condition);
      if (transfer.once) json_.member("once", true);
    });
    objects("work", material_.work, [&](const model::Work& work) {
      json_.member("name", work.name);
      location("at", work.at);
      condition("when", work.condition);
      json_.member("from", material_.kinds[work.from].name);
      json_.member("to", material_.kinds[work.to].name);
    });
    objects("sources", material_.sources, [&](const model::Source& source) { write_source(source); });
    json_.end_object();
  }

 private:
  template <class Range, class Members>
  void objects(std::string_view key, const Range& range, Members members) {
    json_.key(key);
    json_.array(range, [&](const auto& element) {
      json_.begin_object();
      members(element);
      json_.end_object();
    });
  }

  void write_track(const model::Track& track) {
    json_.member("name", track.name);
    json_.member("length", track.length);
    json_.member("gap", track.gap);
    objects("drives", track.drives, [&](const model::Drive& drive) {
      json_.member("until", drive.until);
      condition("forward", drive.forward);
      condition("backward", drive.backward);
      json_.member("speed", drive.speed);
      if (drive.symbol != model::kNone) json_.member("of", plant_.symbols[drive.symbol].name());
      if (drive.output != model::kNone) json_.member("of", model::output_name(plant_, drive.output));
    });
    objects("stops", track.stops, [&](const model::Stop& stop) {
      json_.member("at", stop.at);
      condition("when", stop.condition);
    });
    objects("sensors", track.sensors, [&](const model::PartSensor& sensor) { write_sensor(sensor, true); });
    objects("end", track.ends, [&](const model::TrackEnd& end) {
      location("to", {end.to, tables::kWhole});
      condition("when", end.condition);
    });
  }

  void write_sensor(const model::PartSensor& sensor, bool on_track) {
    json_.member("symbol", plant_.symbols[sensor.symbol].name());
    if (on_track) json_.member("at", sensor.at);
    if (!sensor.kinds.empty()) kinds("kinds", sensor.kinds);
    if (plant_.symbols[sensor.symbol].inverted) json_.member("inverted", true);
    if (sensor.reads == tables::SensorReads::code) json_.member("reads", "code");
    if (sensor.reads == tables::SensorReads::number) json_.member("reads", "number");
  }

  void write_source(const model::Source& source) {
    json_.member("name", source.name);
    location("at", source.to);
    kinds("kinds", source.kinds);
    if (source.every) {
      json_.key("every");
      write_time(*source.every, json_);
    }
    json_.member("first", source.first);
    condition("when", source.condition);
    if (source.count) json_.member("count", *source.count);
  }

  void kinds(std::string_view key, const std::vector<std::uint32_t>& numbers) {
    json_.key(key);
    json_.array(numbers, [&](std::uint32_t kind) { json_.value(material_.kinds[kind].name); });
  }

  /// Without a position where it is the start, the end or a place.
  void location(std::string_view key, const tables::PartLocation& at) {
    json_.key(key);
    json_.begin_object();
    json_.member("location", at.location == tables::kOut ? std::string("out") : material_.location_name(at.location));
    if (at.at != tables::kWhole) json_.member("at", at.at);
    json_.end_object();
  }

  void condition(std::string_view key, const std::optional<condition::Tree>& tree) {
    if (tree) json_.member(key, model::condition_text(*tree, plant_));
  }

  const model::PlantModel& plant_;
  const model::Material& material_;
  JsonWriter& json_;
};

}  // namespace

void write_material(const model::PlantModel& plant, JsonWriter& json) {
  if (plant.material.empty()) return;
  json.key("material");
  MaterialWriter(plant, json).write();
}

}  // namespace symplant::view
