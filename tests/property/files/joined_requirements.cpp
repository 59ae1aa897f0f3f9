// Requirements for each device that a pattern matches.
#include "property/files/joined_requirements.hpp"

#include <algorithm>
#include <optional>

#include "property/files/said.hpp"

namespace symplant::property::files {
namespace {

using description::GivenRequirement;

constexpr std::size_t kMostMade = 12;

/// The texts of a requirement with braces.
constexpr std::string GivenRequirement::*kTexts[] = {&GivenRequirement::name, &GivenRequirement::never,
                                                     &GivenRequirement::after, &GivenRequirement::expect};

bool same(const GivenRequirement& a, const GivenRequirement& b) {
  return std::all_of(std::begin(kTexts), std::end(kTexts), [&](auto text) { return a.*text == b.*text; }) &&
         a.within == b.within && a.earliest == b.earliest;
}

/// The paths of all units, in the order of their first symbols.
std::vector<std::string> paths_of(const model::PlantModel& plant) {
  std::vector<std::string> paths;
  for (const model::Unit& unit : plant.units) paths.emplace_back(unit.path);
  return paths;
}

std::string requirement_pattern(Dice& dice, const std::string& path) {
  const std::string process = path.substr(0, path.find_last_of('_') + 1);
  switch (dice.below(8)) {
    case 0:
      return "*";
    case 1:
      return "L?_*";
    case 2:
      return process + "*";
    case 3:
      return "*_?_D*";
    case 4:
      return path.substr(0, path.size() - 1) + "?";
    case 5:
      return path;
    default:
      return random_pattern(dice, path);
  }
}

struct Made {
  std::vector<GivenRequirement> requirements;
  long left_out = 0;
};

/// What one with `for` makes; nothing if some device could not read it.
std::optional<Made> made_by(const GivenRequirement& given, const std::vector<std::string>& paths,
                            const KnownNames& known) {
  Made made;
  for (const std::string& path : paths) {
    if (!fits(path, given.of)) continue;
    const BraceNames names = brace_names(path, given.of);
    GivenRequirement each = given;
    each.of.clear();
    bool has_all = true;
    for (const auto text : kTexts) {
      if (text != &GivenRequirement::name && !stays_a_condition(given.*text, names)) return std::nullopt;
      each.*text = expanded(given.*text, names);
      has_all = has_all && (text == &GivenRequirement::name || knows(known, each.*text));
    }
    made.left_out += has_all ? 0 : 1;
    if (has_all) made.requirements.push_back(std::move(each));
  }
  return made;
}

GivenRequirement braced(Dice& dice, GivenRequirement given, const std::string& path, std::string pattern) {
  const BraceNames names = brace_names(path, pattern);
  for (const auto text : kTexts) given.*text = with_braces(dice, given.*text, names);
  given.of = std::move(pattern);
  return given;
}

std::string random_condition_of(Dice& dice, const std::string& path, const std::vector<std::string>& states) {
  const auto atom = [&] {
    return (dice.percent(30) ? "not " : "") + path + "." + (dice.percent(20) ? "moving" : dice.pick(states));
  };
  return dice.percent(50) ? atom() : atom() + (dice.percent(50) ? " and " : " or ") + atom();
}

class Joiner {
 public:
  Joiner(const PlantText& plant, const Style& style, const KnownNames& known)
      : given_(plant.description.requirements),
        paths_(paths_of(build(plant).plant)),
        dice_(style.seed ^ 0xF0A),
        known_(known) {}

  std::vector<GivenRequirement> join(bool patterns, Counts& counts) {
    std::vector<GivenRequirement> all;
    for (std::size_t i = 0; i < given_.size();) {
      std::size_t count = 1;
      all.push_back(given_[i]);
      for (int tries = 0; patterns && !paths_.empty() && tries < 40; ++tries) {
        const std::string& path = dice_.pick(paths_);
        const GivenRequirement joined = braced(dice_, given_[i], path, requirement_pattern(dice_, path));
        const auto made = made_by(joined, paths_, known_);
        if (!made || !begins(made->requirements, i) || (made->requirements.size() == 1 && tries < 30)) continue;
        all.back() = joined;
        count = made->requirements.size();
        ++counts[Seen::requirements_for];
        counts[Seen::requirements_for_several] += count > 1 ? 1 : 0;
        counts[Seen::requirements_left_out] += made->left_out;
        break;
      }
      i += count;
    }
    return all;
  }

 private:
  /// Whether these are the given ones from an index on.
  bool begins(const std::vector<GivenRequirement>& made, std::size_t first) const {
    if (made.empty() || made.size() > given_.size() - first) return false;
    return std::equal(made.begin(), made.end(), given_.begin() + static_cast<std::ptrdiff_t>(first), same);
  }

  const std::vector<GivenRequirement>& given_;
  const std::vector<std::string> paths_;
  Dice dice_;
  const KnownNames& known_;
};

}  // namespace

void add_joinable_requirements(Dice& dice, PlantText& plant, const std::string& path) {
  const model::PlantModel model = build(plant).plant;
  const KnownNames known = known_names(model);
  const auto unit =
      std::find_if(model.units.begin(), model.units.end(), [&](const model::Unit& each) { return each.path == path; });
  if (unit == model.units.end()) return;
  std::vector<std::string> states;
  for (const model::State& state : unit->states) states.push_back(state.name);
  const std::vector<std::string> paths = paths_of(model);
  for (std::size_t i = 1 + dice.below(3); i > 0; --i) {
    GivenRequirement given;
    given.name = "f" + std::to_string(i) + " of " + path;
    if (dice.percent(50)) {
      given.never = random_condition_of(dice, path, states);
    } else {
      given.after = random_condition_of(dice, path, states);
      given.expect = random_condition_of(dice, path, states);
      given.within = static_cast<tables::Time>(dice.below(30)) * 100 * tables::kMillisecond;
      if (dice.percent(30)) given.earliest = given.within / 2;
    }
    given.of = requirement_pattern(dice, path);
    for (const auto text : kTexts) {
      std::string& each = given.*text;
      for (std::size_t at = 0; (at = each.find(path, at)) != each.npos; at += 6)
        each.replace(at, path.size(), "{self}");
    }
    const auto made = made_by(given, paths, known);
    if (!made || made->requirements.size() > kMostMade) continue;
    auto& requirements = plant.description.requirements;
    requirements.insert(requirements.end(), made->requirements.begin(), made->requirements.end());
  }
}

std::vector<GivenRequirement> joined_requirements(const PlantText& plant, const Style& style, const KnownNames& known,
                                                  Counts& counts) {
  return Joiner(plant, style, known).join(style.patterns, counts);
}

}  // namespace symplant::property::files
