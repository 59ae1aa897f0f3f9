// The material flow of a plant.json.
#include "property/files/material_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "property/files/json_printer.hpp"

namespace symplant::property::files {
namespace {

using nlohmann::json;

class MaterialWriter {
 public:
  MaterialWriter(Sayer& sayer, Counts& counts) : sayer_(sayer), counts_(counts) {}

  json write(const description::GivenMaterial& material) {
    json said = json::object();
    for (const description::GivenKind& kind : material.kinds) add(said["kinds"], kind.name, this->kind(kind));
    for (const description::GivenTrack& track : material.tracks) add(said["tracks"], track.name, this->track(track));
    for (const description::GivenPlace& place : material.places) add(said["places"], place.name, this->place(place));
    for (const description::GivenTransfer& given : material.transfers) said["transfers"].push_back(transfer(given));
    for (const description::GivenWork& given : material.work) said["work"].push_back(work(given));
    for (const description::GivenSource& given : material.sources) said["sources"].push_back(source(given));
    return said;
  }

 private:
  /// The order of these objects is that of their indices.
  static void add(json& object, const std::string& name, json entry) {
    object[name] = std::move(entry);
    object[kOrder].push_back(name);
  }

  void count(Seen what, bool seen = true) { counts_[what] += seen ? 1 : 0; }

  void condition(json& entry, const char* key, const std::string& text) {
    if (!text.empty()) entry[key] = sayer_.condition(text);
  }

  void pattern(json& entry, const std::string& of) {
    if (!of.empty()) entry["for"] = sayer_.name(of);
  }

  json kind(const description::GivenKind& given) {
    json said = {{"length", sayer_.length(given.length)}};
    if (given.weight != 0) said["weight"] = given.weight;
    if (given.code != 0 || sayer_.dice.percent(20)) said["code"] = given.code;
    return said;
  }

  json track(const description::GivenTrack& given) {
    json said = {{"length", sayer_.length(given.length)}};
    pattern(said, given.of);
    if (given.gap != 0) said["gap"] = sayer_.length(given.gap);
    count(Seen::gaps, given.gap != 0);
    for (const description::GivenDrive& drive : given.drives) said["drives"].push_back(this->drive(drive));
    for (const description::GivenStop& stop : given.stops) {
      said["stops"].push_back({{"at", sayer_.length(stop.at)}, {"when", sayer_.condition(stop.when)}});
      count(Seen::stops);
    }
    sensors(said, given.sensors);
    end(said, given.ends);
    return said;
  }

  json drive(const description::GivenDrive& given) {
    json said = json::object();
    if (given.until) said["until"] = sayer_.length(*given.until);
    count(Seen::drives_until, given.until.has_value());
    condition(said, "forward", given.forward);
    condition(said, "backward", given.backward);
    count(Seen::drives_backward, !given.backward.empty());
    said["speed"] = sayer_.speed(given.speed.speed);
    if (given.speed.of.empty()) return said;
    said["speed"] = {{"of", sayer_.name(given.speed.of)}, {"unit", said["speed"]}};
    count(Seen::speeds_of_symbols);
    return said;
  }

  void sensors(json& entry, const std::vector<description::GivenSensor>& sensors) {
    for (const description::GivenSensor& given : sensors) {
      json said = {{"symbol", sayer_.name(given.symbol)}};
      if (given.at) said["at"] = sayer_.length(*given.at);
      for (const std::string& kind : given.kinds) said["kinds"].push_back(sayer_.name(kind));
      if (given.inverted) said["inverted"] = true;
      if (given.reads == tables::SensorReads::code) said["reads"] = "code";
      if (given.reads == tables::SensorReads::number) said["reads"] = "number";
      count(given.at ? Seen::sensors_of_tracks : Seen::sensors_of_places);
      count(Seen::sensors_of_kinds, !given.kinds.empty());
      count(Seen::inverted_sensors, given.inverted);
      count(Seen::reads_code, given.reads == tables::SensorReads::code);
      count(Seen::reads_number, given.reads == tables::SensorReads::number);
      entry["sensors"].push_back(std::move(said));
    }
  }

  void end(json& track, const std::vector<description::GivenEnd>& ends) {
    if (ends.size() == 1 && ends.front().when.empty() && sayer_.dice.percent(60)) {
      track["end"] = sayer_.name(ends.front().to);
      return count(Seen::single_ends);
    }
    for (const description::GivenEnd& given : ends) {
      json said = {{"to", sayer_.name(given.to)}};
      condition(said, "when", given.when);
      track["end"].push_back(std::move(said));
    }
    count(ends.empty() ? Seen::hard_ends : Seen::listed_ends);
  }

  json place(const description::GivenPlace& given) {
    json said = json::object();
    pattern(said, given.of);
    if (given.holds != 1 || sayer_.dice.percent(20)) said["holds"] = given.holds;
    sensors(said, given.sensors);
    count(Seen::places);
    return said;
  }

  json transfer(const description::GivenTransfer& given) {
    json said = {{"name", given.name}, {"from", sayer_.location(given.from)}, {"to", sayer_.location(given.to)}};
    pattern(said, given.of);
    condition(said, "when", given.when);
    if (given.once) said["once"] = true;
    count(Seen::transfers);
    count(Seen::transfers_once, given.once);
    return said;
  }

  json work(const description::GivenWork& given) {
    json said = {{"name", given.name},
                 {"at", sayer_.location(given.at)},
                 {"from", sayer_.name(given.from)},
                 {"to", sayer_.name(given.to)}};
    pattern(said, given.of);
    condition(said, "when", given.when);
    count(Seen::work);
    return said;
  }

  json source(const description::GivenSource& given) {
    json said = {{"name", given.name}, {"at", sayer_.location(given.at)}};
    pattern(said, given.of);
    for (const std::string& kind : given.kinds) said["kind"].push_back(sayer_.name(kind));
    if (given.kinds.size() == 1 && sayer_.dice.percent(70)) said["kind"] = json(said["kind"].front());
    if (given.every) said["every"] = sayer_.duration(*given.every);
    if (given.first != 0) said["first"] = sayer_.time(given.first);
    condition(said, "when", given.when);
    if (given.count) said["count"] = *given.count;
    count(Seen::sources);
    count(Seen::sources_of_kinds, given.kinds.size() > 1);
    count(Seen::sources_counted, given.count.has_value());
    count(Seen::sources_at_random, given.every && given.every->kind != description::Duration::Kind::fixed);
    return said;
  }

  Sayer& sayer_;
  Counts& counts_;
};

}  // namespace

json material_json(const description::GivenMaterial& material, Sayer& sayer, Counts& counts) {
  if (!material.empty()) ++counts[Seen::material];
  return MaterialWriter(sayer, counts).write(material);
}

}  // namespace symplant::property::files
