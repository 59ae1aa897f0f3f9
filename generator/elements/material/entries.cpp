// Makes the entries of the material flow.
#include "elements/material/entries.hpp"

#include <algorithm>
#include <utility>

#include "model/matched_names.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::ticked;

using description::Pointer;

/// Calls `edit(text, pointer)` for every text of an entry that may have names in braces, except for its name.
template <class Edit>
void edit_all(std::vector<std::string>& texts, const Pointer& here, Edit edit) {
  for (std::size_t i = 0; i < texts.size(); ++i) edit(texts[i], here / i);
}

template <class Edit>
void edit_sensors(std::vector<description::GivenSensor>& sensors, const Pointer& here, Edit edit) {
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    edit(sensors[i].symbol, here / i / "symbol");
    edit_all(sensors[i].kinds, here / i / "kinds", edit);
  }
}

template <class Edit>
void edit_texts(description::GivenTrack& track, const Pointer& here, Edit edit) {
  for (std::size_t i = 0; i < track.drives.size(); ++i) {
    edit(track.drives[i].forward, here / "drives" / i / "forward");
    edit(track.drives[i].backward, here / "drives" / i / "backward");
    edit(track.drives[i].speed.of, here / "drives" / i / "speed" / "of");
  }
  for (std::size_t i = 0; i < track.stops.size(); ++i) edit(track.stops[i].when, here / "stops" / i / "when");
  edit_sensors(track.sensors, here / "sensors", edit);
  for (std::size_t i = 0; i < track.ends.size(); ++i) {
    edit(track.ends[i].to, here / "end" / i / "to");
    edit(track.ends[i].when, here / "end" / i / "when");
  }
}

template <class Edit>
void edit_texts(description::GivenPlace& place, const Pointer& here, Edit edit) {
  edit_sensors(place.sensors, here / "sensors", edit);
}

template <class Edit>
void edit_texts(description::GivenTransfer& transfer, const Pointer& here, Edit edit) {
  edit(transfer.from, here / "from");
  edit(transfer.to, here / "to");
  edit(transfer.when, here / "when");
}

template <class Edit>
void edit_texts(description::GivenWork& work, const Pointer& here, Edit edit) {
  edit(work.at, here / "at");
  edit(work.when, here / "when");
  edit(work.from, here / "from");
  edit(work.to, here / "to");
}

template <class Edit>
void edit_texts(description::GivenSource& source, const Pointer& here, Edit edit) {
  edit(source.at, here / "at");
  edit(source.when, here / "when");
  edit_all(source.kinds, here / "kind", edit);
}

class Maker {
 public:
  Maker(const PlantModel& plant, description::Faults& faults) : plant_(plant), faults_(faults) {}

  /// `keyed`: the list is an object, and its keys are the names.
  template <class Entry>
  void make(const std::vector<Entry>& given, std::string_view list, bool keyed, std::vector<Entry>& made,
            std::vector<MadeBy>& origins) {
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      MadeBy by{i, keyed ? given[i].name : std::string(), given[i].of, {}, {}};
      const Pointer here = material_pointer(list, by);
      const Pointer name = keyed ? here : here / "name";
      if (!given[i].of.empty()) {
        make_for(given[i], here, name, by, made, origins);
        continue;
      }
      made.push_back(given[i]);
      refuse_braces(made.back(), here, name);
      origins.push_back(std::move(by));
    }
  }

 private:
  /// Reports names in braces of an entry without `for`, and removes their texts, so that they are reported only once.
  /// In quotes they may be part of a name.
  template <class Entry>
  void refuse_braces(Entry& entry, const Pointer& here, const Pointer& name) {
    const auto refuse = [&](const std::string& text, const Pointer& at) {
      const std::size_t open = text.find('{');
      if (open == text.npos || text.find('\'') < open) return false;
      faults_.add(at, ticked(text.substr(open, text.find('}', open) + 1 - open)) +
                          " is replaced by a name only with `for`; add `for`, or write the name");
      return true;
    };
    refuse(entry.name, name);
    edit_texts(entry, here, [&](std::string& text, const Pointer& at) {
      if (refuse(text, at)) text.clear();
    });
  }

  template <class Entry>
  void make_for(const Entry& given, const Pointer& here, const Pointer& name, const MadeBy& by,
                std::vector<Entry>& made, std::vector<MadeBy>& origins) {
    const bool any = for_each_device(plant_, given.of, [&](const Unit& unit) {
      const MatchedNames matched = MatchedNames::of(plant_, unit, given.of);
      Entry entry = given;
      const auto replace = [&](std::string& text, const Pointer& at) {
        if (!text::has_braces(text)) return true;
        text::Replaced replaced = matched.replace(text);
        text = replaced.unknown.empty() ? std::move(replaced.text) : std::string();
        if (replaced.unknown.empty()) return true;
        faults_.add(at, ticked(replaced.unknown) + " is unknown here; use one of " + matched.choices(),
                    description::FaultKind::unknown_name);
        return false;
      };
      const bool named = replace(entry.name, name);
      edit_texts(entry, here, [&](std::string& text, const Pointer& at) { replace(text, at); });
      if (!named) return;
      made.push_back(std::move(entry));
      origins.push_back(by);
      origins.back().device = unit.device_path();
    });
    if (!any) {
      faults_.warn(here / "for", ticked(given.of) + " matches no device", description::FaultKind::matches_nothing);
    }
  }

  const PlantModel& plant_;
  description::Faults& faults_;
};

}  // namespace

Pointer material_pointer(std::string_view list, const MadeBy& by) {
  const Pointer here = Pointer("/material") / list;
  const bool keyed = list == "tracks" || list == "places";
  const Pointer entry = keyed ? here / std::string_view(by.key) : here / std::size_t{by.given};
  return by.pattern.empty() ? entry : entry.matched_by(by.pattern);
}

bool for_devices(const description::GivenMaterial& given) {
  const auto any = [](const auto& entries) {
    return std::any_of(entries.begin(), entries.end(), [](const auto& entry) { return !entry.of.empty(); });
  };
  return any(given.tracks) || any(given.places) || any(given.transfers) || any(given.work) || any(given.sources);
}

MadeMaterial make_material(const PlantModel& plant, const description::GivenMaterial& given,
                           description::Faults& faults) {
  MadeMaterial made;
  made.entries.kinds = given.kinds;
  Maker maker(plant, faults);
  maker.make(given.tracks, "tracks", true, made.entries.tracks, made.tracks);
  maker.make(given.places, "places", true, made.entries.places, made.places);
  maker.make(given.transfers, "transfers", false, made.entries.transfers, made.transfers);
  maker.make(given.work, "work", false, made.entries.work, made.work);
  maker.make(given.sources, "sources", false, made.entries.sources, made.sources);
  return made;
}

}  // namespace symplant::model
