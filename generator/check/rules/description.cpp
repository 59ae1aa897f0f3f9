// Rules: plant.json: states, conditions, requirements, and the section `check`.
#include <algorithm>
#include <optional>

#include "check/rule.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

using condition::Atom;
using condition::Tree;
using description::DeviceKey;
using description::key_pointer;
using description::Pointer;

/// Whether a description has devices or requirements, and no faults, so that it can be examined.
bool is_described(const Find& find) {
  const description::Description& description = *find.plant.description;
  return find.evidence.faults.empty() && (!description.devices.empty() || !description.requirements.empty());
}

/// In the description of a unit, or at its first symbol if that is by the naming rule.
diag::Location described(const Find& find, const Unit& unit, const Pointer& pointer) {
  const Symbol& first = find.symbols[unit.first_symbol()];
  diag::Location fallback = location_of(find.plant, *first.row, first.name());
  return unit.described->by_naming ? fallback : location_of(pointer, std::move(fallback));
}

Finding at(const Find& find, const Unit& unit, const Pointer& pointer) {
  return find.at(described(find, unit, pointer), {{{Kind::device, std::string(unit.path)}}, {}, {}});
}

/// Where a transition is given.
Pointer pointer_of(const Unit& unit, const Transition& transition) {
  return key_pointer(*unit.described, DeviceKey::transitions) / std::size_t{transition.given};
}

/// Where a state is given, or transitions are missing: at `only`, which removes the derived ones, or at the device.
Pointer pointer_of(const Unit& unit, const State& state) {
  for (std::size_t i = 0; i < unit.described->states.size(); ++i) {
    if (!text::equal_ignoring_case(unit.described->states[i], state.name)) continue;
    return key_pointer(*unit.described, DeviceKey::states) / i;
  }
  if (unit.described->only) return key_pointer(*unit.described, DeviceKey::only);
  const auto& entries = unit.described->from;
  const auto* entry =
      std::ranges::find_if(entries, [](const auto* each) { return each != nullptr && !each->by_naming; });
  return description::device_pointer(entry == entries.end() ? *unit.described : **entry);
}

/// Whether a unit may enter a state: at the start, by a transition, a spring or custom code, or as nothing drives it.
bool may_enter(const Unit& unit, std::uint32_t state) {
  return state == unit.initial || unit.reaches(state) || !unit.moves();
}

void unreachable_state(const Find& find, const Unit& unit) {
  if (!is_described(find) || unit.described == nullptr) return;
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (may_enter(unit, s) || is_left_alone(unit, s)) continue;  // SP402 reports it
    at(find, unit, pointer_of(unit, unit.states[s]))
        .say("nothing leads to `{}` of `{}`, so only a scenario or a person can set that state: add a transition",
             unit.states[s].name, unit.path);
  }
}

constexpr std::uint64_t kMoving = ~std::uint64_t{0};  ///< the value of a unit that is in no state

bool is_of_unit(const Atom& atom) { return atom.kind == Atom::Kind::settled || atom.kind == Atom::Kind::moving; }

bool holds(const Atom& atom, std::uint64_t value) {
  if (!is_of_unit(atom)) return value != 0;
  return value == (atom.kind == Atom::Kind::moving ? kMoving : atom.state);
}

/// Tries values of the units and bits that a condition tests, until it is decided: a unit is in one state at most and
/// not moving at the same time. Units, bits and comparisons of numbers count as independent of each other, and after
/// some 100,000 steps the condition counts as open: "never" and "always" are certain, the opposite is not.
class Search {
 public:
  /// `entered`: only states that units may enter.
  Search(const Tree& tree, const PlantModel& plant, bool entered) : root_(tree), plant_(plant), entered_(entered) {}

  /// Whether the condition may have a truth value.
  bool can_be(bool wanted) {
    constexpr std::size_t kMostSteps = std::size_t{1} << 17U;
    open_ = nullptr;
    const std::optional<bool> now = truth(root_);
    if (now || steps_ > kMostSteps) return now.value_or(wanted) == wanted;
    const Atom& atom = *open_;
    const std::vector<std::uint64_t> values = values_of(atom);
    chosen_.emplace_back(key(atom), 0);
    const bool found = std::ranges::any_of(values, [&](std::uint64_t value) {
      chosen_.back().second = value;
      return can_be(wanted);
    });
    chosen_.pop_back();
    return found;
  }

 private:
  /// Equal for atoms of one unit or bit, and for equal comparisons of a number.
  static Atom key(const Atom& atom) { return is_of_unit(atom) ? Atom{Atom::Kind::settled, atom.of} : atom; }

  /// The states of a unit, or false and true.
  std::vector<std::uint64_t> values_of(const Atom& atom) const {
    if (!is_of_unit(atom)) return {0, 1};
    const Unit& unit = plant_.units[atom.of];
    std::vector<std::uint64_t> values;
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      if (!entered_ || may_enter(unit, s)) values.push_back(s);
    }
    if (unit.moves()) values.push_back(kMoving);
    return values;
  }

  /// Nothing as long as it depends on atoms without a value, the first of which is `open_`.
  std::optional<bool> truth(const Tree& tree) {
    ++steps_;
    if (tree.kind == Tree::Kind::constant) return tree.value;
    if (tree.kind == Tree::Kind::atom) {
      const auto value = std::ranges::find(chosen_, key(tree.atom), &std::pair<Atom, std::uint64_t>::first);
      if (value != chosen_.end()) return holds(tree.atom, value->second);
      if (open_ == nullptr) open_ = &tree.atom;
      return std::nullopt;
    }
    const bool negation = tree.kind == Tree::Kind::negation;
    const bool decisive = tree.kind == Tree::Kind::any;
    bool open = false;
    for (const Tree& child : tree.children) {
      const std::optional<bool> part = truth(child);
      if (part && (negation || *part == decisive)) return *part != negation;
      open = open || !part;
    }
    return open ? std::nullopt : std::optional(!decisive);
  }

  const Tree& root_;
  const PlantModel& plant_;
  bool entered_;
  std::vector<std::pair<Atom, std::uint64_t>> chosen_;
  const Atom* open_ = nullptr;
  std::size_t steps_ = 0;
};

/// Reports a condition that never or always holds.
void report_decided(Finding finding, std::string_view text, const Tree& tree, bool entered = false) {
  const bool never = !Search(tree, finding.plant, entered).can_be(true);
  const bool always = !Search(tree, finding.plant, entered).can_be(false);
  if (never || always) finding.say("`{}` {}: correct it", text, never ? "can never hold" : "always holds");
}

void decided_conditions_of(const Find& find, const Unit& unit) {
  std::vector<bool> seen(unit.conditions.size());
  const auto look_at = [&](std::uint32_t condition, const Pointer& pointer, std::string_view text) {
    if (condition >= seen.size() || seen[condition]) return;
    seen[condition] = true;
    report_decided(at(find, unit, pointer), text, unit.conditions[condition]);
  };
  for (const Transition& transition : unit.transitions) {
    if (transition.given == kNone) continue;
    const description::GivenTransition& given = unit.described->transitions[transition.given];
    look_at(transition.when, pointer_of(unit, transition) / "when", given.when);
    look_at(transition.during, pointer_of(unit, transition) / "while", given.during);
  }
  for (const auto& [name, text] : unit.described->inputs) {  // some may be left out
    const auto index = std::ranges::find(unit.input_names, name) - unit.input_names.begin();
    look_at(unit.first_input + static_cast<std::uint32_t>(index),
            key_pointer(*unit.described, DeviceKey::inputs) / std::string_view(name), text);
  }
}

void condition_decided(const Find& find) {
  if (!is_described(find)) return;
  for (const Unit& unit : find.units) {
    if (!unit.conditions.empty()) decided_conditions_of(find, unit);
  }
  for (const model::Requirement& requirement : find.plant.requirements) {
    const description::GivenRequirement& given = find.plant.description->requirements[requirement.given];
    const auto look_at = [&](std::string_view key, const std::string& text, const Tree& tree) {
      const Pointer pointer = Pointer("/requirements") / std::size_t{requirement.given} / key;
      report_decided(find.at(location_of(pointer), {{{Kind::requirement, requirement.name}}, {}, {}}), text, tree,
                     true);
    };
    const bool never = requirement.kind == tables::RequirementRow::Kind::never;
    look_at(never ? "never" : "after", never ? given.never : given.after, requirement.condition);
    if (!never) look_at("expect", given.expect, requirement.expected);
  }
}

constexpr Rule kDescriptionRules[] = {
    {"SP610", "unreachable-state", kWarning, unreachable_state, "nothing leads to a state",
     "It is not the initial state, and no transition, no return of a spring and no custom code enters it.",
     "The device never enters the state: its event never comes on.",
     "Add a transition, or remove `\"only\": true`. If only a scenario should enter the state, ignore the finding."},
    {"SP614", "condition-decided", kWarning, condition_decided, "a condition never holds, or always holds",
     "It wants one device in two states at once (`AGV.P1 and AGV.P2`), or holds whatever happens (`not AGV.P1 or not "
     "AGV.P2`). In a requirement it may name a state that nothing leads to.",
     "A transition never fires, or too early; a requirement that cannot fail tests nothing.",
     "Most often `and` is written for `or`, or the state of another device is meant."},
    {"SP620", "settings-outdated", kWarning, nullptr, "an entry of `check` has no effect, or uses a former name",
     "An entry of `ignore` matches no finding, is past its `until`, or names a rule by the name of an earlier version.",
     "Nothing. But an entry that hides nothing today may hide a fault tomorrow.",
     "Remove or correct it. Patterns are compared with the symbol, device, requirement or value."},
    {"SP622", "settings-not-valid", kError, nullptr,
     "`check` has an unknown rule, an invalid date, or an error that cannot be ignored",
     "An error after which there is no valid plant is not lowered or ignored. A date is written like `2027-06-30`.",
     "The entry has no effect.", "Correct the entry; the message has the nearest rule. `symplant rules` lists all."},
    {"SP626", "baseline-stale", kWarning, nullptr, "a baseline has findings that are no longer there",
     "They are fixed. The other findings of the file still count.",
     "Nothing. But an entry that hides nothing today may hide a fault tomorrow.",
     "Run the same command with `--write-baseline` instead of `--baseline`."},
    {"SP627", "baseline-not-valid", kError, nullptr, "the file of `--baseline` is not a baseline",
     "It is not valid JSON, or it has other keys or values.",
     "Nothing is checked, so that no finding is hidden by mistake.",
     "Restore the file, or delete it and run `symplant check PLANT --write-baseline FILE`."},
};

}  // namespace

std::span<const Rule> description_rules() { return kDescriptionRules; }

}  // namespace symplant::check
