// Resolves the requirements of the description.
#include "elements/requirement/resolve.hpp"

#include <string>
#include <unordered_set>
#include <utility>

namespace symplant::model {
namespace {

class Requirements {
 public:
  Requirements(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults)
      : plant_(plant), conditions_(conditions), made_(made), faults_(faults) {}

  void run() {
    const auto& given = plant_.description->requirements;
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      const description::Pointer here = description::Pointer("/requirements") / std::size_t{i};
      if (given[i].name.empty()) faults_.add(here / "name", "this requirement has no name; give it one");
      const bool never = !given[i].never.empty();
      if (never == (!given[i].after.empty() || !given[i].expect.empty()) ||
          given[i].after.empty() != given[i].expect.empty()) {
        faults_.add(here, "a requirement needs either `never`, or `after` with `expect`");
      } else if (given[i].of.empty()) {
        if (!refuse_braces(given[i], here)) add_requirement(i, nullptr, {}, here);
      } else {
        add_requirements_for(i, here.matched_by(given[i].of));
      }
    }
  }

 private:
  /// Whether a requirement without `for` has names in braces, which is a fault. In quotes they may be part of a name.
  bool refuse_braces(const description::GivenRequirement& given, const description::Pointer& here) {
    bool refused = false;
    for (const auto& [text, key] : {std::pair<const std::string&, std::string_view>(given.name, "name"),
                                    {given.never, "never"},
                                    {given.after, "after"},
                                    {given.expect, "expect"}}) {
      const std::size_t open = text.find('{');
      if (open == text.npos || (key != "name" && text.find('\'') < open)) continue;
      faults_.add(here / key, description::ticked(text.substr(open, text.find('}', open) + 1 - open)) +
                                  " is replaced by a name only with `for`; add `for`, or write the name");
      refused = true;
    }
    return refused;
  }

  /// One requirement for each device that `for` matches.
  void add_requirements_for(std::uint32_t index, const description::Pointer& here) {
    const std::string& pattern = plant_.description->requirements[index].of;
    const bool any = for_each_device(plant_, pattern, [&](const Unit& unit) {
      const MatchedNames matched = MatchedNames::of(plant_, unit, pattern);
      add_requirement(index, &matched, unit.device_path(), here);
    });
    if (!any) {
      faults_.warn(here / "for", description::ticked(pattern) + " matches no device",
                   description::FaultKind::matches_nothing);
    }
  }

  /// `matched` is null without `for`.
  void add_requirement(std::uint32_t index, const MatchedNames* matched, std::string_view device,
                       const description::Pointer& here) {
    const description::GivenRequirement& given = plant_.description->requirements[index];
    Requirement requirement;
    requirement.given = index;
    requirement.kind = given.never.empty() ? tables::RequirementRow::Kind::expect : tables::RequirementRow::Kind::never;
    requirement.within = given.within;
    requirement.earliest = given.earliest;
    requirement.name = given.name;
    if (matched != nullptr && text::has_braces(given.name)) {
      auto name = conditions_.make(given.name, *matched, here / "name");
      if (!name) return;
      requirement.name = std::move(*name);
    }
    std::string lacking;
    const auto read = [&](const std::string& text, std::string_view key, condition::Tree& tree) {
      if (text.empty()) return true;
      return matched == nullptr ? conditions_.resolve(text, here / key, tree)
                                : conditions_.resolve_made(text, *matched, here / key, tree, &lacking);
    };
    bool sound = read(given.never, "never", requirement.condition);
    sound = read(given.after, "after", requirement.condition) && sound;
    sound = read(given.expect, "expect", requirement.expected) && sound;
    if (matched != nullptr) made_.takes(here);
    if (!lacking.empty()) made_.lacks(here, device, std::move(lacking));
    if (requirement.name.empty() || !sound) return;
    if (!names_.insert(requirement.name).second) {
      faults_.add(here / "name", description::ticked(requirement.name) + " already names another requirement; " +
                                     (matched == nullptr ? "choose another name" : "use `{self}` in the name"));
    }
    plant_.requirements.push_back(std::move(requirement));
  }

  PlantModel& plant_;
  ConditionReader& conditions_;
  MadeNames& made_;
  description::Faults& faults_;
  std::unordered_set<std::string> names_;
};

}  // namespace

void resolve_requirements(PlantModel& plant, ConditionReader& conditions, MadeNames& made,
                          description::Faults& faults) {
  Requirements(plant, conditions, made, faults).run();
}

}  // namespace symplant::model
