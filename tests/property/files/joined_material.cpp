// Entries of the material flow for each device that a pattern matches.
#include "property/files/joined_material.hpp"

#include <algorithm>
#include <utility>

#include "property/files/braces.hpp"
#include "property/files/said.hpp"
#include "property/text_material.hpp"

namespace symplant::property::files {
namespace {

using description::GivenMaterial;

constexpr std::size_t kMostMadeEntries = 8;

/// Calls `visit` with every text that may have braces.
template <class Visit>
void texts_of(std::vector<description::GivenSensor>& sensors, Visit visit) {
  for (description::GivenSensor& given : sensors) {
    visit(given.symbol);
    for (std::string& kind : given.kinds) visit(kind);
  }
}
template <class Visit>
void texts_of(description::GivenTrack& given, Visit visit) {
  visit(given.name);
  for (description::GivenDrive& drive : given.drives) {
    visit(drive.forward);
    visit(drive.backward);
    visit(drive.speed.of);
  }
  for (description::GivenStop& stop : given.stops) visit(stop.when);
  texts_of(given.sensors, visit);
  for (description::GivenEnd& end : given.ends) {
    visit(end.to);
    visit(end.when);
  }
}
template <class Visit>
void texts_of(description::GivenPlace& given, Visit visit) {
  visit(given.name);
  texts_of(given.sensors, visit);
}
template <class Visit>
void texts_of(description::GivenTransfer& given, Visit visit) {
  for (std::string* text : {&given.name, &given.from, &given.to, &given.when}) visit(*text);
}
template <class Visit>
void texts_of(description::GivenWork& given, Visit visit) {
  for (std::string* text : {&given.name, &given.at, &given.from, &given.to, &given.when}) visit(*text);
}
template <class Visit>
void texts_of(description::GivenSource& given, Visit visit) {
  for (std::string* text : {&given.name, &given.at, &given.when}) visit(*text);
  for (std::string& kind : given.kinds) visit(kind);
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

/// What an entry with `for` makes.
template <class Entry>
std::vector<Entry> entries_of(const Entry& given, const std::vector<std::string>& paths) {
  std::vector<Entry> made;
  for (const std::string& path : paths) {
    if (!fits(path, given.of)) continue;
    const BraceNames names = brace_names(path, given.of);
    made.push_back(given);
    made.back().of.clear();
    texts_of(made.back(), [&](std::string& text) { text = expanded(text, names); });
  }
  return made;
}

class MaterialJoiner {
 public:
  MaterialJoiner(const PlantText& plant, const Style& style, Counts& counts)
      : paths_(devices_of(plant)), dice_(style.seed ^ 0xF0B), counts_(counts) {}

  template <class Entry>
  void join(GivenMaterial& material, std::vector<Entry> GivenMaterial::*list) {
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
        texts_of(joined, [&](std::string& text) { text = with_braces(dice_, text, names); });
        const auto same_key = [&](const Entry& other) {
          return other.name == joined.name;
        };  // as one with another `for`
        if (std::any_of((material.*list).begin(), (material.*list).end() - 1, same_key)) continue;
        const std::vector<Entry> made = entries_of(joined, paths_);
        if (!begins(list, made, given, i) || (made.size() == 1 && tries < 9)) continue;
        (material.*list).back() = joined;
        count = made.size();
        ++counts_[Seen::material_for];
        counts_[Seen::material_for_several] += count > 1 ? 1 : 0;
        break;
      }
      i += count;
    }
  }

 private:
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
    const auto made = entries_of(given, paths);
    if (made.size() <= kMostMadeEntries) list.insert(list.end(), made.begin(), made.end());
  };
  const std::string& track = dice.pick(material.tracks).name;
  const std::string& kind = dice.pick(material.kinds).name;
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
  joiner.join(material, &GivenMaterial::tracks);
  joiner.join(material, &GivenMaterial::places);
  joiner.join(material, &GivenMaterial::transfers);
  joiner.join(material, &GivenMaterial::work);
  joiner.join(material, &GivenMaterial::sources);
  return material;
}

}  // namespace symplant::property::files
