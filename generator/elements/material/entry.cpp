// Reads `material` of a plant.json.
#include "elements/material/entry.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "description/units.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;

class MaterialReader {
 public:
  MaterialReader(const Json& value, ShapeFaults& faults) : value_(value), faults_(faults) {}

  GivenMaterial read() {
    each_of("kinds", [this](const std::string& name, const Json& entry, const Pointer& here) {
      GivenKind kind{name, length(entry, "length", here, length_above_zero).value_or(0), 0, 0};
      const Json* code = member(entry, "code");
      if (code != nullptr && code->is_number_unsigned()) kind.code = code->get<std::uint32_t>();
      const Json* weight = member(entry, "weight");
      if (weight != nullptr && weight->is_number()) kind.weight = weight->get<double>();
      material_.kinds.push_back(std::move(kind));
    });
    each_of("tracks", [this](const std::string& name, const Json& entry, const Pointer& here) {
      material_.tracks.push_back(track(name, entry, here));
    });
    each_of("places", [this](const std::string& name, const Json& entry, const Pointer& here) {
      GivenPlace place{name, text_or_empty(entry, "for"), 1, sensors(entry, here)};
      const Json* holds = member(entry, "holds");
      if (holds != nullptr && holds->is_number_unsigned()) place.holds = holds->get<std::uint32_t>();
      material_.places.push_back(std::move(place));
    });
    each_in("transfers", [this](const Json& entry, const Pointer& here) {
      check_text(text_or_empty(entry, "name"), here / "name", faults_);
      material_.transfers.push_back({text_or_empty(entry, "name"), text_or_empty(entry, "for"),
                                     text_or_empty(entry, "from"), text_or_empty(entry, "to"),
                                     text_or_empty(entry, "when"), flag_member(entry, "once")});
    });
    each_in("work", [this](const Json& entry, const Pointer& here) {
      check_text(text_or_empty(entry, "name"), here / "name", faults_);
      material_.work.push_back({text_or_empty(entry, "name"), text_or_empty(entry, "for"), text_or_empty(entry, "at"),
                                text_or_empty(entry, "when"), text_or_empty(entry, "from"),
                                text_or_empty(entry, "to")});
    });
    each_in("sources",
            [this](const Json& entry, const Pointer& here) { material_.sources.push_back(source(entry, here)); });
    return std::move(material_);
  }

 private:
  /// Calls `function(name, entry, pointer)` for each member of an object.
  template <class Function>
  void each_of(std::string_view key, Function function) {
    const Json* object = member(value_, key);
    if (object == nullptr || !object->is_object()) return;
    const Pointer here = Pointer("/material") / key;
    for (const auto& [name, entry] : object->items()) {
      check_text(name, here / name, faults_);
      function(name, entry, here / name);
    }
  }

  template <class Function>
  void each_in(std::string_view key, Function function) {
    each(member(value_, key), Pointer("/material") / key, function);
  }

  /// Calls `function(entry, pointer)` for each entry of an array.
  template <class Function>
  static void each(const Json* array, const Pointer& here, Function function) {
    if (array == nullptr || !array->is_array()) return;
    for (std::size_t i = 0; i < array->size(); ++i) function((*array)[i], here / i);
  }

  template <class Read = decltype(&length_of)>
  std::optional<std::int64_t> length(const Json& object, std::string_view key, const Pointer& here,
                                     Read parse = &length_of) {
    const std::string* text = text_member(object, key);
    return text == nullptr ? std::nullopt : parse(*text, here / key, faults_);
  }

  GivenTrack track(const std::string& name, const Json& entry, const Pointer& here) {
    GivenTrack track;
    track.name = name;
    track.of = text_or_empty(entry, "for");
    track.length = length(entry, "length", here, length_above_zero).value_or(0);
    track.gap = length(entry, "gap", here).value_or(0);
    each(member(entry, "drives"), here / "drives",
         [&](const Json& drive, const Pointer& at) { track.drives.push_back(this->drive(drive, at)); });
    each(member(entry, "stops"), here / "stops", [&](const Json& stop, const Pointer& at) {
      track.stops.push_back({length(stop, "at", at).value_or(0), text_or_empty(stop, "when")});
    });
    track.sensors = sensors(entry, here);
    const Json* end = member(entry, "end");
    if (end != nullptr && end->is_string()) track.ends.push_back({end->get<std::string>(), {}});
    each(end, here / "end", [&](const Json& one, const Pointer&) {
      track.ends.push_back({text_or_empty(one, "to"), text_or_empty(one, "when")});
    });
    return track;
  }

  GivenDrive drive(const Json& entry, const Pointer& here) {
    GivenDrive drive;
    drive.until = length(entry, "until", here);
    drive.forward = text_or_empty(entry, "forward");
    drive.backward = text_or_empty(entry, "backward");
    const Json* speed = member(entry, "speed");
    if (speed == nullptr) return drive;
    const bool constant = speed->is_string();
    drive.speed.of = text_or_empty(*speed, "of");
    const std::string text = constant ? speed->get<std::string>() : text_or_empty(*speed, "unit");
    const Pointer at = constant ? here / "speed" : here / "speed" / "unit";
    if (!text.empty()) drive.speed.speed = speed_of(text, at, faults_).value_or(1);
    return drive;
  }

  std::vector<GivenSensor> sensors(const Json& entry, const Pointer& here) {
    std::vector<GivenSensor> all;
    each(member(entry, "sensors"), here / "sensors", [&](const Json& one, const Pointer& at) {
      GivenSensor sensor;
      sensor.symbol = text_or_empty(one, "symbol");
      sensor.at = length(one, "at", at);
      sensor.kinds = names(member(one, "kinds"));
      sensor.inverted = flag_member(one, "inverted");
      const std::string reads = text_or_empty(one, "reads");
      if (reads == "code") sensor.reads = tables::SensorReads::code;
      if (reads == "number") sensor.reads = tables::SensorReads::number;
      all.push_back(std::move(sensor));
    });
    return all;
  }

  /// One name, or an array of names.
  static std::vector<std::string> names(const Json* value) {
    std::vector<std::string> all;
    if (value == nullptr) return all;
    if (value->is_string()) all.push_back(value->get<std::string>());
    if (!value->is_array()) return all;
    for (const Json& one : *value) all.push_back(one.is_string() ? one.get<std::string>() : std::string());
    return all;
  }

  GivenSource source(const Json& entry, const Pointer& here) {
    GivenSource source;
    source.name = text_or_empty(entry, "name");
    check_text(source.name, here / "name", faults_);
    source.of = text_or_empty(entry, "for");
    source.at = text_or_empty(entry, "at");
    source.kinds = names(member(entry, "kind"));
    source.every = duration_member(entry, "every", here, faults_);
    if (source.every && source.every->is_zero()) {
      faults_.add(here / "every", "a source cannot make parts every 0 ns; write a longer time, or remove `every`");
    }
    source.first = time_member(entry, "first", here, faults_).value_or(0);
    source.when = text_or_empty(entry, "when");
    const Json* count = member(entry, "count");
    if (count != nullptr && count->is_number_unsigned()) source.count = count->get<std::uint64_t>();
    return source;
  }

  const Json& value_;
  ShapeFaults& faults_;
  GivenMaterial material_;
};

}  // namespace

void sort_as_written(GivenMaterial& material, const PlantSource& source) {
  sort_as_written(material.kinds, "/material/kinds", source);
  sort_as_written(material.tracks, "/material/tracks", source);
  sort_as_written(material.places, "/material/places", source);
}

GivenMaterial material_entry(const Json& value, ShapeFaults& faults) { return MaterialReader(value, faults).read(); }

}  // namespace symplant::description
