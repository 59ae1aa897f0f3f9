// Resolves the names and conditions of the material flow.
#include "model/resolve_material.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

#include "model/plant_names.hpp"
#include "symplant/tables/length.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::Pointer;
using description::ticked;

bool is_reserved(std::string_view name) {
  return text::equal_ignoring_case(name, "out") || text::equal_ignoring_case(name, "part") ||
         text::equal_ignoring_case(name, "parts");
}

/// Resolves entries. What the plant lacks that an entry with `for` names is no fault: lacking() says it.
class MaterialResolver {
 public:
  /// `track_of`: a track of the plant -> its index among the made ones.
  MaterialResolver(PlantModel& plant, const MadeMaterial& made, const std::vector<std::size_t>& track_of,
                   description::Faults& faults)
      : plant_(plant),
        material_(plant.material),
        made_(made),
        faults_(faults),
        names_(plant, faults),
        track_of_(track_of) {}

  /// One entry; `made` is its index among the made ones.
  void track(std::uint32_t index, std::size_t made) {
    const description::GivenTrack& given = made_.entries.tracks[made];
    const Pointer here = begin("tracks", made_.tracks[made]);
    Track& track = material_.tracks[index];
    track.length = given.length;
    track.gap = given.gap;
    track.given = made_.tracks[made].given;
    drives(given, track, here / "drives");
    for (std::size_t i = 0; i < given.stops.size(); ++i) {
      Stop stop{given.stops[i].at, {}};
      within(given, stop.at, here / "stops" / i / "at");
      resolve(given.stops[i].when, here / "stops" / i / "when", stop.condition);
      track.stops.push_back(std::move(stop));
    }
    sensors(given.sensors, &given, track.sensors, here / "sensors");
    for (std::size_t i = 0; i < given.ends.size(); ++i) {
      TrackEnd end;
      const Pointer at = given.ends.size() == 1 && given.ends[0].when.empty() ? here / "end" : here / "end" / i;
      end.to = target(given.ends[i].to, at);
      end.condition = optional(given.ends[i].when, here / "end" / i / "when");
      track.ends.push_back(std::move(end));
    }
    for (const PartKind& kind : material_.kinds) {
      if (kind.length <= given.length || given.length == 0) continue;
      faults_.add(here / "length", "kind " + ticked(kind.name) + " is longer than this track; make the track longer");
      return;
    }
    if (const std::uint64_t most = most_parts(material_, track); most > tables::kMaxPartsOnTrack) {
      faults_.add(here / "length", "up to " + std::to_string(most) + " parts fit on this track, and the maximum is " +
                                       std::to_string(tables::kMaxPartsOnTrack) +
                                       "; divide the track, or make the parts or the gap longer");
    }
  }

  void place(std::uint32_t index, std::size_t made) {
    const Pointer here = begin("places", made_.places[made]);
    const description::GivenPlace& given = made_.entries.places[made];
    material_.places[index].holds = given.holds;
    material_.places[index].given = made_.places[made].given;
    sensors(given.sensors, nullptr, material_.places[index].sensors, here / "sensors");
  }

  void transfer(std::size_t made) {
    const Pointer here = begin("transfers", made_.transfers[made]);
    const description::GivenTransfer& given = made_.entries.transfers[made];
    Transfer transfer{given.name, location(given.from, here / "from"), {}, optional(given.when, here / "when"),
                      given.once, made_.transfers[made].given};
    transfer.to = text::equal_ignoring_case(given.to, "out") ? tables::PartLocation{} : location(given.to, here / "to");
    unique(transfer_names_, given.name, here);
    const bool out = text::equal_ignoring_case(given.to, "out");
    if (!out && transfer.from.location != tables::kOut && transfer.from == transfer.to) {
      faults_.add(here / "to",
                  "this transfer moves parts from " + ticked(given.from) + " to itself; name another target");
    }
    material_.transfers.push_back(std::move(transfer));
  }

  void work(std::size_t made) {
    const Pointer here = begin("work", made_.work[made]);
    const description::GivenWork& given = made_.entries.work[made];
    Work work{given.name,
              location(given.at, here / "at"),
              {},
              kind(given.from, here / "from"),
              kind(given.to, here / "to"),
              made_.work[made].given};
    resolve(given.when, here / "when", work.condition);
    unique(work_names_, given.name, here);
    if (work.from != kNone && work.to != kNone &&
        material_.kinds[work.from].length != material_.kinds[work.to].length) {
      faults_.add(here / "to", ticked(given.to) + " has another length than " + ticked(given.from) +
                                   "; work cannot change the length of parts");
    }
    material_.work.push_back(std::move(work));
  }

  void source(std::size_t made) {
    const Pointer here = begin("sources", made_.sources[made]);
    const description::GivenSource& given = made_.entries.sources[made];
    Source source{given.name,
                  location(given.at, here / "at"),
                  {},
                  given.every,
                  given.first,
                  given.count,
                  optional(given.when, here / "when"),
                  made_.sources[made].given};
    for (const std::string& each : given.kinds) source.kinds.push_back(kind(each, here / "kind"));
    unique(source_names_, given.name, here);
    material_.sources.push_back(std::move(source));
  }

  /// What the last entry names and the plant lacks; empty: nothing.
  const std::string& lacking() const { return lacking_; }

 private:
  Pointer begin(std::string_view list, const MadeBy& by) {
    made_for_device_ = !by.pattern.empty();
    lacking_ = by.lacking;
    return material_pointer(list, by);
  }

  void unknown(const Pointer& here, std::string message) {
    if (made_for_device_) {
      if (lacking_.empty()) lacking_ = std::move(message);
    } else {
      faults_.add(here, std::move(message), description::FaultKind::unknown_name);
    }
  }

  bool resolve(const std::string& text, const Pointer& here, condition::Tree& tree) {
    auto parsed = condition::parse(text);
    if (auto* fault = std::get_if<condition::Fault>(&parsed)) {
      faults_.add(here, (made_for_device_ ? ticked(text) + ": " : std::string()) + fault->message,
                  description::FaultKind::condition, made_for_device_ ? 0 : fault->index.offset);
      return false;
    }
    auto resolved = condition::resolve(std::get<condition::Expression>(parsed), names_);
    if (auto* found = std::get_if<condition::Tree>(&resolved)) {
      tree = std::move(*found);
      return true;
    }
    auto& fault = std::get<condition::Fault>(resolved);
    if (made_for_device_) {
      if (lacking_.empty()) lacking_ = std::move(fault.message);
    } else {
      faults_.add(here, std::move(fault.message), description::FaultKind::condition, fault.index.offset);
    }
    return false;
  }

  std::optional<condition::Tree> optional(const std::string& text, const Pointer& here) {
    condition::Tree tree;
    if (text.empty() || !resolve(text, here, tree)) return std::nullopt;
    return tree;
  }

  void drives(const description::GivenTrack& given, Track& track, const Pointer& here) {
    std::int64_t before = 0;
    for (std::size_t i = 0; i < given.drives.size(); ++i) {
      const description::GivenDrive& drive = given.drives[i];
      const bool last = i + 1 == given.drives.size();
      if (drive.until.has_value() == last) {
        faults_.add(here / i, last ? "the last drive moves parts up to the end of the track; remove `until`"
                                   : "only the last drive has no `until`; write up to where this one moves parts");
      }
      Drive made{drive.until.value_or(given.length), optional(drive.forward, here / i / "forward"),
                 optional(drive.backward, here / i / "backward"), drive.speed.speed, kNone};
      if (!drive.speed.of.empty()) made.symbol = speed_symbol(drive.speed.of, here / i / "speed" / "of");
      if (!last && (made.until <= before || made.until >= given.length)) {
        faults_.add(here / i / "until", made.until >= given.length
                                            ? "this is not before the end of the track"
                                            : "the drives must be in order along the track; this is not behind the "
                                              "`until` of the drive before");
      }
      before = made.until;
      track.drives.push_back(std::move(made));
    }
  }

  std::uint32_t speed_symbol(const std::string& name, const Pointer& here) {
    const auto symbol = names_.symbol(name);
    if (!symbol) {
      unknown(here, description::missing("symbol " + ticked(name), names_.nearest_symbol(name)));
      return kNone;
    }
    if (symbol->type != tables::DataType::boolean) return symbol->index;
    faults_.add(here, ticked(name) + " is BOOL; a speed comes from a numeric symbol");
    return kNone;
  }

  void within(const description::GivenTrack& track, std::int64_t at, const Pointer& here) {
    if (at > track.length && track.length != 0) {
      faults_.add(here, "this is beyond the end of track " + ticked(track.name));
    }
  }

  void sensors(const std::vector<description::GivenSensor>& given, const description::GivenTrack* track,
               std::vector<PartSensor>& sensors, const Pointer& here) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto symbol = names_.symbol(given[i].symbol);
      if (track != nullptr && given[i].at) within(*track, *given[i].at, here / i / "at");
      PartSensor sensor{0, given[i].at.value_or(0), {}, given[i].reads};
      for (const std::string& each : given[i].kinds) sensor.kinds.push_back(kind(each, here / i / "kinds"));
      std::sort(sensor.kinds.begin(), sensor.kinds.end());
      sensor.kinds.erase(std::unique(sensor.kinds.begin(), sensor.kinds.end()), sensor.kinds.end());
      if (!symbol || plant_.symbols[symbol->index].unmodelled != Unmodelled::senses_parts) continue;  // reported
      sensor.symbol = symbol->index;
      sensors.push_back(std::move(sensor));
    }
  }

  std::uint32_t kind(const std::string& name, const Pointer& here) {
    if (const auto found = names_.part_kind(name)) return *found;
    unknown(here, description::missing("kind of part " + ticked(name), names_.nearest_part_kind(name)));
    return kNone;
  }

  std::uint32_t target(const std::string& text, const Pointer& here) {
    if (text::equal_ignoring_case(text, "out")) return tables::kOut;
    if (text.find('@') != text.npos) {
      faults_.add(here, "parts arrive at the start of a track, not at a position; write the name of the track only");
      return tables::kOut;
    }
    return location(text, here).location;
  }

  tables::PartLocation location(const std::string& text, const Pointer& here) {
    const tables::LocationText parts = tables::split_location(text);
    const auto found = names_.location(parts.name);
    if (!found) {
      if (text::equal_ignoring_case(parts.name, "out")) {
        faults_.add(here, "`out` is only a target of transfers and ends");
      } else {
        unknown(here, description::missing("track or place " + ticked(parts.name), nearest_location(parts.name)));
      }
      return {};
    }
    tables::PartLocation at{*found, tables::kWhole};
    if (!parts.has_position) return at;
    const auto position = tables::parse_length(parts.position);
    if (!material_.is_track(*found)) {
      faults_.add(here, ticked(parts.name) + " is a place and has no positions; remove `@` and what follows");
    } else if (!position) {
      faults_.add(here, ticked(parts.position) + " is not a length; write a position such as " +
                            ticked(std::string(parts.name) + "@300 mm"));
    } else if (*position > made_.entries.tracks[track_of_[*found]].length) {
      faults_.add(here, "this is beyond the end of track " + ticked(parts.name));
    } else {
      at.at = *position;
    }
    return at;
  }

  std::string nearest_location(std::string_view name) const {
    const std::size_t count = material_.tracks.size() + material_.places.size();
    return std::string(faults_.nearest(name, count, [&](std::size_t i) -> std::string_view {
      return material_.location_name(static_cast<std::uint32_t>(i));
    }));
  }

  void unique(std::unordered_set<std::string>& names, const std::string& name, const Pointer& here) {
    if (!lacking_.empty() || name.empty() || names.insert(text::to_upper(name)).second) return;
    faults_.add(here / "name", ticked(name) + " already names another entry of this list; " +
                                   (made_for_device_ ? "use `{self}` in the name" : "choose another name"));
  }

  PlantModel& plant_;
  Material& material_;
  const MadeMaterial& made_;
  description::Faults& faults_;
  PlantNames names_;
  const std::vector<std::size_t>& track_of_;
  bool made_for_device_ = false;
  std::string lacking_;
  std::unordered_set<std::string> transfer_names_;
  std::unordered_set<std::string> work_names_;
  std::unordered_set<std::string> source_names_;
};

/// Whether each made entry is in the plant: those with `for` are left out if they name what the plant lacks.
struct Included {
  std::vector<bool> tracks;
  std::vector<bool> places;
  std::vector<bool> transfers;
  std::vector<bool> work;
  std::vector<bool> sources;
};

class MaterialBuilder {
 public:
  MaterialBuilder(Derived& derived, MadeNames& names, description::Faults& faults)
      : plant_(derived.plant), made_(derived.material), names_(names), faults_(faults) {}

  void build() {
    Included in{std::vector<bool>(made_.tracks.size(), true), std::vector<bool>(made_.places.size(), true),
                std::vector<bool>(made_.transfers.size(), true), std::vector<bool>(made_.work.size(), true),
                std::vector<bool>(made_.sources.size(), true)};
    check_kinds();
    check_names(in);
    if (some_for()) {
      std::vector<description::DescriptionFault> ignored;
      description::Faults scratch(ignored, ignored);
      while (resolve(in, scratch, false)) {
      }
    }
    resolve(in, faults_, true);
    release_unused_sensors();
  }

 private:
  bool some_for() const {
    const auto any = [](const std::vector<MadeBy>& list) {
      return std::any_of(list.begin(), list.end(), [](const MadeBy& by) { return !by.pattern.empty(); });
    };
    return any(made_.tracks) || any(made_.places) || any(made_.transfers) || any(made_.work) || any(made_.sources);
  }

  void check_kinds() {
    std::unordered_set<std::string> names;
    for (const description::GivenKind& kind : made_.entries.kinds) {
      const Pointer here = Pointer("/material/kinds") / std::string_view(kind.name);
      if (is_reserved(kind.name)) {
        faults_.add({here.text(), ticked(kind.name) + " is a reserved word; choose another name", 0,
                     description::FaultKind::contradiction, true});
      } else if (!names.insert(text::to_upper(kind.name)).second) {
        faults_.add({here.text(), ticked(kind.name) + " appears twice; remove one", 0,
                     description::FaultKind::contradiction, true});
      }
      plant_.material.kinds.push_back({kind.name, kind.length, kind.code});
    }
  }

  /// Tracks and places have one namespace with devices.
  void check_names(Included& in) {
    text::ByName<bool> names;
    for (const Unit& unit : plant_.units) {
      names.try_emplace(unit.path, true);
      names.try_emplace(unit.device_path(), true);
    }
    const auto check = [&](const auto& entries, const std::vector<MadeBy>& origins, std::string_view list,
                           std::vector<bool>& included) {
      for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto [found, added] = names.try_emplace(entries[i].name, false);
        std::string why;
        if (is_reserved(entries[i].name)) {
          why = " is a reserved word; choose another name";
        } else if (!added) {
          why = found->second ? " is the name of a device; choose another name"
                              : " already names another track or place; choose another name";
        }
        if (why.empty()) continue;
        included[i] = false;
        faults_.add({material_pointer(list, origins[i]).text(), ticked(entries[i].name) + why, 0,
                     description::FaultKind::contradiction, true});
      }
    };
    check(made_.entries.tracks, made_.tracks, "tracks", in.tracks);
    check(made_.entries.places, made_.places, "places", in.places);
  }

  /// Resolves what is included. Excludes what names something that the plant lacks; true if there was any. `last`: what
  /// is lacking is reported.
  bool resolve(Included& in, description::Faults& faults, bool last) {
    Material& material = plant_.material;
    std::vector<PartKind> kinds = std::move(material.kinds);
    material = {};
    material.kinds = std::move(kinds);
    std::vector<std::size_t> tracks;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < in.tracks.size(); ++i) {
      if (!in.tracks[i]) continue;
      tracks.push_back(i);
      material.tracks.emplace_back().name = made_.entries.tracks[i].name;
    }
    for (std::size_t i = 0; i < in.places.size(); ++i) {
      if (!in.places[i]) continue;
      places.push_back(i);
      material.places.emplace_back().name = made_.entries.places[i].name;
    }
    MaterialResolver resolver(plant_, made_, tracks, faults);
    bool excluded = false;
    const auto close = [&](std::string_view list, const MadeBy& by, std::vector<bool>& included, std::size_t i) {
      if (resolver.lacking().empty()) return;
      included[i] = false;
      excluded = true;
      lacking_.push_back({material_pointer(list, by).text(), by.device, resolver.lacking()});
    };
    for (std::uint32_t t = 0; t < tracks.size(); ++t) {
      resolver.track(t, tracks[t]);
      close("tracks", made_.tracks[tracks[t]], in.tracks, tracks[t]);
    }
    for (std::uint32_t p = 0; p < places.size(); ++p) {
      resolver.place(p, places[p]);
      close("places", made_.places[places[p]], in.places, places[p]);
    }
    const auto each = [&](const std::vector<MadeBy>& list, std::string_view name, std::vector<bool>& included,
                          auto resolve_one) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (!included[i]) continue;
        resolve_one(i);
        close(name, list[i], included, i);
      }
    };
    each(made_.transfers, "transfers", in.transfers, [&](std::size_t i) { resolver.transfer(i); });
    each(made_.work, "work", in.work, [&](std::size_t i) { resolver.work(i); });
    each(made_.sources, "sources", in.sources, [&](std::size_t i) { resolver.source(i); });
    if (last) report_lacking();
    return excluded;
  }

  void report_lacking() {
    const auto takes = [&](std::string_view list, const std::vector<MadeBy>& origins) {
      for (const MadeBy& by : origins) {
        if (!by.pattern.empty()) names_.takes(material_pointer(list, by));
      }
    };
    takes("tracks", made_.tracks);
    takes("places", made_.places);
    takes("transfers", made_.transfers);
    takes("work", made_.work);
    takes("sources", made_.sources);
    for (Lacking& lacking : lacking_) {
      names_.lacks(Pointer(lacking.pointer), lacking.device, std::move(lacking.message));
    }
  }

  /// Symbols of sensors whose entry was left out.
  void release_unused_sensors() {
    std::vector<bool> used(plant_.symbols.size());
    const auto use = [&](const std::vector<PartSensor>& sensors) {
      for (const PartSensor& sensor : sensors) used[sensor.symbol] = true;
    };
    for (const Track& track : plant_.material.tracks) use(track.sensors);
    for (const Place& place : plant_.material.places) use(place.sensors);
    for (std::size_t i = 0; i < used.size(); ++i) {
      Symbol& symbol = plant_.symbols[i];
      if (symbol.unmodelled == Unmodelled::senses_parts && !used[i]) symbol.unmodelled = Unmodelled::unpaired;
    }
  }

  struct Lacking {
    std::string pointer;
    std::string device;
    std::string message;
  };

  PlantModel& plant_;
  const MadeMaterial& made_;
  MadeNames& names_;
  description::Faults& faults_;
  std::vector<Lacking> lacking_;
};

}  // namespace

std::uint64_t most_parts(const Material& material, const Track& track) {
  if (material.kinds.empty()) return 0;
  const auto [shortest, longest] =
      std::minmax_element(material.kinds.begin(), material.kinds.end(),
                          [](const PartKind& a, const PartKind& b) { return a.length < b.length; });
  const std::int64_t least = shortest->length + track.gap;
  if (least == 0) return 0;  // reported
  return static_cast<std::uint64_t>((track.length + longest->length) / least + 1);
}

void resolve_material(Derived& derived, MadeNames& made, description::Faults& faults) {
  if (derived.plant.description->material.empty()) return;
  MaterialBuilder(derived, made, faults).build();
}

}  // namespace symplant::model
