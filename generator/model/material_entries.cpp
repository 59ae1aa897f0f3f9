// Makes the entries of the material flow.
#include "model/material_entries.hpp"

#include <initializer_list>
#include <unordered_set>
#include <utility>

#include "model/matched_names.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

using description::ticked;

/// Calls `edit(text)` for every text of an entry that may have names in braces, except for its name.
template <class Edit>
void edit_sensors(std::vector<description::GivenSensor>& sensors, Edit edit) {
  for (description::GivenSensor& sensor : sensors) {
    edit(sensor.symbol);
    for (std::string& kind : sensor.kinds) edit(kind);
  }
}

template <class Edit>
void edit_texts(description::GivenTrack& track, Edit edit) {
  for (description::GivenDrive& drive : track.drives) {
    edit(drive.forward);
    edit(drive.backward);
    edit(drive.speed.of);
  }
  for (description::GivenStop& stop : track.stops) edit(stop.when);
  edit_sensors(track.sensors, edit);
  for (description::GivenEnd& end : track.ends) {
    edit(end.to);
    edit(end.when);
  }
}

template <class Edit>
void edit_texts(description::GivenPlace& place, Edit edit) {
  edit_sensors(place.sensors, edit);
}

template <class Edit>
void edit_texts(description::GivenTransfer& transfer, Edit edit) {
  for (std::string* text : {&transfer.from, &transfer.to, &transfer.when}) edit(*text);
}

template <class Edit>
void edit_texts(description::GivenWork& work, Edit edit) {
  for (std::string* text : {&work.at, &work.when, &work.from, &work.to}) edit(*text);
}

template <class Edit>
void edit_texts(description::GivenSource& source, Edit edit) {
  edit(source.at);
  edit(source.when);
  for (std::string& kind : source.kinds) edit(kind);
}

class Maker {
 public:
  Maker(const PlantModel& plant, description::Faults& faults) : plant_(plant), faults_(faults) {}

  template <class Entry>
  void make(const std::vector<Entry>& given, std::string_view list, std::vector<Entry>& made,
            std::vector<MadeBy>& origins) {
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      MadeBy by{i, list == "tracks" || list == "places" ? given[i].name : std::string(), given[i].of, {}, {}};
      if (!given[i].of.empty()) {
        make_for(given[i], list, by, made, origins);
        continue;
      }
      Entry entry = given[i];
      if (refuse_braces(entry, material_pointer(list, by))) continue;
      made.push_back(std::move(entry));
      origins.push_back(std::move(by));
    }
  }

 private:
  template <class Entry>
  bool refuse_braces(Entry& entry, const description::Pointer& here) {
    std::string found;
    const auto look = [&](const std::string& text) {
      const std::size_t open = text.find('{');
      if (open == text.npos || text.find('\'') < open || !found.empty()) return;  // in quotes it may be part of a name
      found = text.substr(open, text.find('}', open) + 1 - open);
    };
    look(entry.name);
    edit_texts(entry, look);
    if (found.empty()) return false;
    faults_.add(here, ticked(found) + " is replaced by a name only with `for`; add `for`, or write the name");
    return true;
  }

  template <class Entry>
  void make_for(const Entry& given, std::string_view list, const MadeBy& by, std::vector<Entry>& made,
                std::vector<MadeBy>& origins) {
    std::unordered_set<std::string_view> devices;
    const description::Pointer here = material_pointer(list, by);
    for (const Unit& unit : plant_.units) {
      if (!text::matches_pattern(unit.device_path(), given.of) || !devices.insert(unit.device_path()).second) continue;
      const MatchedNames matched = MatchedNames::of(plant_, unit, given.of);
      Entry entry = given;
      entry.of.clear();
      std::string unknown;
      const auto replace = [&](std::string& text) {
        if (!text::has_braces(text)) return;
        text::Replaced replaced = matched.replace(text);
        if (unknown.empty()) unknown = replaced.unknown;
        text = std::move(replaced.text);
      };
      replace(entry.name);
      edit_texts(entry, replace);
      if (!unknown.empty()) {
        faults_.add(here, ticked(unknown) + " is unknown here; use one of " + matched.choices(),
                    description::FaultKind::unknown_name);
        return;
      }
      made.push_back(std::move(entry));
      origins.push_back(by);
      origins.back().device = unit.device_path();
    }
    if (devices.empty()) {
      faults_.warn(here / "for", ticked(given.of) + " matches no device", description::FaultKind::matches_nothing);
    }
  }

  const PlantModel& plant_;
  description::Faults& faults_;
};

}  // namespace

description::Pointer material_pointer(std::string_view list, const MadeBy& by) {
  const description::Pointer here = description::Pointer("/material") / list;
  const description::Pointer entry = by.key.empty() ? here / std::size_t{by.given} : here / std::string_view(by.key);
  return by.pattern.empty() ? entry : entry.matched_by(by.pattern);
}

MadeMaterial make_material(const PlantModel& plant, const description::GivenMaterial& given,
                           description::Faults& faults) {
  MadeMaterial made;
  made.entries.kinds = given.kinds;
  Maker maker(plant, faults);
  maker.make(given.tracks, "tracks", made.entries.tracks, made.tracks);
  maker.make(given.places, "places", made.entries.places, made.places);
  maker.make(given.transfers, "transfers", made.entries.transfers, made.transfers);
  maker.make(given.work, "work", made.entries.work, made.work);
  maker.make(given.sources, "sources", made.entries.sources, made.sources);
  return made;
}

}  // namespace symplant::model
