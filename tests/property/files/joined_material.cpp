// Entries of the material flow for each device that a pattern matches.
#include "property/files/joined_material.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "property/files/braces.hpp"
#include "property/files/said.hpp"
#include "property/text_material.hpp"
#include "support/reference/rules.hpp"

namespace symplant::property::files {
namespace {

using description::GivenMaterial;

constexpr std::size_t kMostMadeEntries = 8;

/// What a text of an entry names.
enum class Names : std::uint8_t { itself, condition, symbol, kind, location };

/// Calls `visit(text, names)` with every text that may have braces.
template <class Visit>
void texts_of(std::vector<description::GivenSensor>& sensors, Visit visit) {
  for (description::GivenSensor& given : sensors) {
    visit(given.symbol, Names::symbol);
    for (std::string& kind : given.kinds) visit(kind, Names::kind);
  }
}
template <class Visit>
void texts_of(description::GivenTrack& given, Visit visit) {
  visit(given.name, Names::itself);
  for (description::GivenDrive& drive : given.drives) {
    visit(drive.forward, Names::condition);
    visit(drive.backward, Names::condition);
    visit(drive.speed.of, Names::symbol);
  }
  for (description::GivenStop& stop : given.stops) visit(stop.when, Names::condition);
  texts_of(given.sensors, visit);
  for (description::GivenEnd& end : given.ends) {
    visit(end.to, Names::location);
    visit(end.when, Names::condition);
  }
}
template <class Visit>
void texts_of(description::GivenPlace& given, Visit visit) {
  visit(given.name, Names::itself);
  texts_of(given.sensors, visit);
}
template <class Visit>
void texts_of(description::GivenTransfer& given, Visit visit) {
  visit(given.name, Names::itself);
  visit(given.from, Names::location);
  visit(given.to, Names::location);
  visit(given.when, Names::condition);
}
template <class Visit>
void texts_of(description::GivenWork& given, Visit visit) {
  visit(given.name, Names::itself);
  visit(given.at, Names::location);
  visit(given.when, Names::condition);
  visit(given.from, Names::kind);
  visit(given.to, Names::kind);
}
template <class Visit>
void texts_of(description::GivenSource& given, Visit visit) {
  visit(given.name, Names::itself);
  visit(given.at, Names::location);
  visit(given.when, Names::condition);
  for (std::string& kind : given.kinds) visit(kind, Names::kind);
}

/// Whether an entry has sensors; a symbol of theirs belongs to no device, even if the entry is left out.
bool has_sensors(const auto& given) {
  if constexpr (requires { given.sensors; }) return !given.sensors.empty();
  return false;
}

/// The entry as lines of text, without its pattern.
template <class Entry>
std::vector<std::string> lines_of_entry(std::vector<Entry> GivenMaterial::*list, const Entry& entry) {
  GivenMaterial only;
  (only.*list).push_back(entry);
  return material_lines(only);
}

/// The devices that `for` matches: symbols of sensors belong to them, too.
std::vector<std::string> devices_of(PlantText plant) {
  plant.description.material = {};
  const model::PlantModel model = build(plant).plant;
  std::vector<std::string> paths;
  for (const model::Unit& unit : model.units) paths.emplace_back(unit.path);
  return paths;
}

const std::vector<std::string> kPatterns = {"*", "L?_*", "L0_*", "*_P_*", "*1"};

std::string entry_pattern(Dice& dice, const std::string& path) {
  const std::size_t kind = dice.below(100);
  if (kind < 40) return dice.pick(kPatterns);
  return kind < 70 ? path.substr(0, path.size() - 1) + "?" : random_pattern(dice, path);
}

/// Decides what a plant has.
class Known {
 public:
  explicit Known(const PlantText& plant) : plant_(plant), names_(known_names(build(plant).plant)) {}

  bool has(const std::string& text, Names names) const {
    const GivenMaterial& material = plant_.description.material;
    const auto is_it = [&](const auto& entry) { return reference::same_name(entry.name, text); };
    const auto any = [&](const auto& list) { return std::any_of(list.begin(), list.end(), is_it); };
    switch (names) {
      case Names::itself:
        return true;
      case Names::condition:
        return knows(names_, text);
      case Names::symbol:
        return text.empty() || any(plant_.rows);
      case Names::kind:
        return any(material.kinds);
      case Names::location:
        if (const std::size_t at = text.find('@'); at != text.npos) return has(text.substr(0, at), names);
        return text == "out" || any(material.tracks) || any(material.places);
    }
    return false;
  }

 private:
  const PlantText& plant_;
  const KnownNames names_;
};

template <class Entry>
struct MadeEntries {
  std::vector<Entry> entries;
  std::vector<std::string> left_out;  ///< names, in upper case
};

/// What an entry with `for` makes; nothing if some device could not read it.
template <class Entry>
std::optional<MadeEntries<Entry>> entries_of(const Entry& given, const std::vector<std::string>& paths,
                                             const Known& known) {
  MadeEntries<Entry> made;
  for (const std::string& path : paths) {
    if (!fits(path, given.of)) continue;
    const BraceNames names = brace_names(path, given.of);
    Entry each = given;
    each.of.clear();
    bool reads = true;
    bool has_all = true;
    texts_of(each, [&](std::string& text, Names of) {
      reads = reads && (of != Names::condition || stays_a_condition(text, names));
      text = expanded(text, names);
      has_all = has_all && known.has(text, of);
    });
    if (!reads || (!has_all && has_sensors(given))) return std::nullopt;
    if (has_all) {
      made.entries.push_back(std::move(each));
    } else {
      made.left_out.push_back(reference::upper(each.name));
    }
  }
  return made;
}

class MaterialJoiner {
 public:
  MaterialJoiner(const PlantText& plant, const Style& style, Counts& counts)
      : paths_(devices_of(plant)), known_(plant), dice_(style.seed ^ 0xF0B), counts_(counts) {}

  template <class Entry>
  void join(GivenMaterial& material, std::vector<Entry> GivenMaterial::*list, std::set<std::string>& taken) {
    const std::vector<Entry> given = material.*list;
    (material.*list).clear();
    for (std::size_t i = 0; i < given.size();) {
      std::size_t count = 1;
      (material.*list).push_back(given[i]);
      for (int tries = 0; !paths_.empty() && tries < 12; ++tries) {
        const std::string& path = dice_.pick(paths_);
        Entry joined = given[i];
        joined.of = entry_pattern(dice_, path);
        if (!fits(path, joined.of)) continue;
        const BraceNames names = brace_names(path, joined.of);
        texts_of(joined, [&](std::string& text, Names) { text = with_braces(dice_, text, names); });
        const auto same_key = [&](const Entry& other) {
          return other.name == joined.name;
        };  // as one with another `for`
        if (std::any_of((material.*list).begin(), (material.*list).end() - 1, same_key)) continue;
        const auto made = entries_of(joined, paths_, known_);
        if (!made || !begins(list, made->entries, given, i) || (made->entries.size() == 1 && tries < 9)) continue;
        if (!takes(made->left_out, taken)) continue;
        (material.*list).back() = joined;
        count = made->entries.size();
        ++counts_[Seen::material_for];
        counts_[Seen::material_for_several] += count > 1 ? 1 : 0;
        counts_[Seen::material_left_out] += std::ssize(made->left_out);
        break;
      }
      i += count;
    }
  }

 private:
  /// The names of entries that are left out must be unique, too.
  static bool takes(const std::vector<std::string>& left_out, std::set<std::string>& taken) {
    std::set<std::string> all = taken;
    all.insert(left_out.begin(), left_out.end());
    if (all.size() < taken.size() + left_out.size()) return false;
    taken = std::move(all);
    return true;
  }

  /// Whether these are the given ones from an index on.
  template <class Entry>
  static bool begins(std::vector<Entry> GivenMaterial::*list, const std::vector<Entry>& made,
                     const std::vector<Entry>& given, std::size_t first) {
    if (made.empty() || made.size() > given.size() - first) return false;
    return std::equal(
        made.begin(), made.end(), given.begin() + static_cast<std::ptrdiff_t>(first),
        [&](const Entry& a, const Entry& b) { return lines_of_entry(list, a) == lines_of_entry(list, b); });
  }

  const std::vector<std::string> paths_;
  const Known known_;
  Dice dice_;
  Counts& counts_;
};

}  // namespace

void add_joinable_material(Dice dice, PlantText& plant) {
  GivenMaterial& material = plant.description.material;
  if (material.tracks.empty() || material.kinds.empty() || dice.percent(60)) return;
  const std::vector<std::string> paths = devices_of(plant);
  const std::string of = dice.pick(kPatterns);
  const auto add = [&](auto& list, auto given) {
    given.of = of;
    const auto made = entries_of(given, paths, Known(plant));
    if (!made || made->entries.size() > kMostMadeEntries) return;
    list.insert(list.end(), made->entries.begin(), made->entries.end());
  };
  const std::string track = dice.pick(material.tracks).name;
  const std::string kind = dice.pick(material.kinds).name;
  const std::string when = dice.percent(70) ? "{self}.moving" : "not {self}.moving";
  if (dice.percent(60)) {
    description::GivenSource source;
    source.name = "s {self}";
    source.at = dice.percent(50) ? track : track + "@0um";
    source.kinds.push_back(kind);
    source.when = when;
    source.count = 1 + dice.below(3);
    add(material.sources, std::move(source));
  }
  if (dice.percent(30)) return;
  const std::string from = dice.percent(50) ? track : track + "@0um";
  add(material.places, description::GivenPlace{"BOX_{self}", "", 2, {}});
  add(material.transfers, description::GivenTransfer{"t {self}", "", from, "BOX_{self}", when, true});
}

GivenMaterial joined_material(const PlantText& plant, const Style& style, Counts& counts) {
  GivenMaterial material = plant.description.material;
  if (!style.patterns || material.empty()) return material;
  MaterialJoiner joiner(plant, style, counts);
  const auto join = [&](auto GivenMaterial::*list, std::set<std::string> taken) {
    for (const auto& given : material.*list) taken.insert(reference::upper(given.name));
    joiner.join(material, list, taken);
    return taken;
  };
  std::set<std::string> locations;
  for (const description::GivenPlace& place : material.places) locations.insert(reference::upper(place.name));
  join(&GivenMaterial::places, join(&GivenMaterial::tracks, locations));
  join(&GivenMaterial::transfers, {});
  join(&GivenMaterial::work, {});
  join(&GivenMaterial::sources, {});
  return material;
}

}  // namespace symplant::property::files
