// Sets the times of transitions that `times` of the description gives.
#include "elements/times/resolve.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

using description::FaultKind;
using description::GivenTime;
using description::GivenTimes;
using description::Pointer;
using description::ticked;

constexpr std::size_t kExact = std::numeric_limits<std::size_t>::max();

/// An entry of `times`.
struct TimesEntry {
  const GivenTimes* given;
  bool exact;            ///< it names one unit
  std::size_t literals;  ///< characters other than `*` and `?`: how specific a pattern is; kExact: a name
  std::size_t matched = 0;
  std::size_t held = 0;  ///< of the matched devices
};

/// A time of an entry for one unit.
struct UnitTime {
  std::uint64_t code;  ///< of its states and operation
  const GivenTime* given;
  bool found = false;  ///< the unit has such a transition
};

/// An entry that matches a unit.
struct MatchedEntry {
  TimesEntry* entry;
  std::vector<UnitTime> times = {};  ///< sorted by code
};

/// Equal for the same transitions. kNone: every state, or whatever causes the transition.
std::uint64_t code_of(std::uint32_t from, std::uint32_t to, std::uint32_t on) {
  static_assert(tables::kMaxStates < 0xFFFF && tables::kMaxOperations < 0xFFFF);
  return std::uint64_t{from & 0xFFFFU} << 32U | std::uint64_t{to} << 16U | std::uint64_t{on & 0xFFFFU};
}

/// Whether the spring takes the unit from a state to its rest state by no transition.
bool returns_without_transition(const Unit& unit, std::uint32_t from) {
  if (unit.actuation != tables::Actuation::spring || from == unit.rest) return false;
  return std::none_of(unit.transitions.begin(), unit.transitions.end(), [&](const Transition& t) {
    return t.from == from && t.to == unit.rest && (t.on != kNone || t.spring_return);
  });
}

class TimesResolver {
 public:
  TimesResolver(PlantModel& plant, TimeFormulas& formulas, MadeNames& made, description::Faults& faults)
      : plant_(plant), formulas_(formulas), made_(made), faults_(faults) {}

  /// How many devices each pattern matches, in words.
  std::vector<std::string> run() {
    std::vector<TimesEntry*> exact(plant_.units.size());
    find_entries(exact);
    std::vector<MatchedEntry> matched;
    for (std::size_t u = 0; u < plant_.units.size(); ++u) {
      Unit& unit = plant_.units[u];
      matched.clear();
      if (exact[u] != nullptr) matched.push_back({exact[u]});
      for (TimesEntry* pattern : patterns_) {
        if (matches(*pattern, unit)) matched.push_back({pattern});
      }
      if (!matched.empty()) apply(unit, matched);
    }
    report_patterns();
    std::vector<std::string> decisions;
    for (const TimesEntry* pattern : patterns_) {
      if (pattern->literals == kExact) continue;
      decisions.push_back(ticked(pattern->given->device) + " of `times` matches " + std::to_string(pattern->matched) +
                          (pattern->matched == 1 ? " device" : " devices"));
    }
    return decisions;
  }

 private:
  static Pointer pointer_of(const GivenTimes& given) { return Pointer("/times") / std::string_view(given.device); }
  static Pointer pointer_of(const TimesEntry& entry, const GivenTime& time) {
    const Pointer here = pointer_of(*entry.given) / std::string_view(time.key);
    return entry.exact ? here : here.matched_by(entry.given->device);
  }

  void find_entries(std::vector<TimesEntry*>& exact) {
    const std::vector<GivenTimes>& given = plant_.description->times;
    entries_.reserve(given.size());
    text::ByName<std::size_t> units;
    for (const GivenTimes& times : given) {
      if (text::is_pattern(times.device)) {
        entries_.push_back({&times, false, text::literal_characters(times.device)});
        patterns_.push_back(&entries_.back());
        continue;
      }
      if (units.empty()) {
        for (std::size_t u = 0; u < plant_.units.size(); ++u) units.try_emplace(plant_.units[u].path, u);
      }
      find_exact(times, units, exact);
    }
    std::stable_sort(patterns_.begin(), patterns_.end(),
                     [](const TimesEntry* a, const TimesEntry* b) { return a->literals > b->literals; });
  }

  void find_exact(const GivenTimes& times, const text::ByName<std::size_t>& units, std::vector<TimesEntry*>& exact) {
    const auto found = units.find(times.device);
    if (found == units.end() && has_facets(times.device)) {
      entries_.push_back({&times, false, kExact});
      patterns_.push_back(&entries_.back());
    } else if (found == units.end()) {
      const auto nearest =
          faults_.nearest(times.device, plant_.units.size(), [&](std::size_t i) { return plant_.units[i].path; });
      faults_.add(pointer_of(times), description::missing("device " + ticked(times.device), nearest),
                  FaultKind::unknown_name);
    } else if (exact[found->second] != nullptr) {
      description::DescriptionFault fault{pointer_of(times).text(),
                                          ticked(times.device) + " has two entries in `times`; merge both"};
      fault.related = pointer_of(*exact[found->second]->given).text();
      fault.related_message = "the other entry";
      faults_.add(std::move(fault));
    } else {
      entries_.push_back({&times, true, kExact});
      exact[found->second] = &entries_.back();
    }
  }

  /// Whether a device of that name consists of several units.
  bool has_facets(std::string_view device) const {
    return std::any_of(plant_.units.begin(), plant_.units.end(), [&](const Unit& unit) {
      return unit.facet != nullptr && text::equal_ignoring_case(unit.facet->path, device);
    });
  }

  static bool matches(const TimesEntry& pattern, const Unit& unit) {
    return text::matches_pattern(unit.path, pattern.given->device) ||
           (unit.facet != nullptr && text::matches_pattern(unit.facet->path, pattern.given->device));
  }

  /// `matched` is sorted: the most specific entry first.
  void apply(Unit& unit, std::vector<MatchedEntry>& matched) {
    for (MatchedEntry& entry : matched) {
      ++entry.entry->matched;
      find_times(unit, entry);
    }
    add_spring_returns(unit, matched);
    for (Transition& transition : unit.transitions) set_times(unit, transition, matched);
    for (const MatchedEntry& entry : matched) {
      for (const UnitTime& time : entry.times) {
        if (!time.found) report_no_transition(unit, *entry.entry, *time.given);
      }
    }
    set_overrun(unit, matched);
  }

  /// Finds the states and operations of an entry's keys.
  void find_times(const Unit& unit, MatchedEntry& entry) {
    entry.times.reserve(entry.entry->given->transitions.size());
    for (const GivenTime& given : entry.entry->given->transitions) {
      const bool from_all = given.of.from == "*";
      std::uint32_t from = kNone;
      std::uint32_t to = kNone;
      std::uint32_t on = kNone;
      if (!from_all && !find_state(unit, given.of.from, *entry.entry, given, from)) continue;
      if (!find_state(unit, given.of.to, *entry.entry, given, to)) continue;
      if (!given.of.on.empty() && !find_operation(unit, *entry.entry, given, on)) continue;
      entry.times.push_back({code_of(from, to, on), &given});
    }
    std::stable_sort(entry.times.begin(), entry.times.end(),
                     [](const UnitTime& a, const UnitTime& b) { return a.code < b.code; });
    const auto same = [&](const UnitTime& first, const UnitTime& second) {
      if (first.code != second.code) return false;
      faults_.add(pointer_of(*entry.entry, *second.given), ticked(second.given->key) + " means the transition of " +
                                                               ticked(first.given->key) + "; remove one of the two");
      return true;
    };
    entry.times.erase(std::unique(entry.times.begin(), entry.times.end(), same), entry.times.end());
  }

  bool find_state(const Unit& unit, const std::string& name, const TimesEntry& entry, const GivenTime& given,
                  std::uint32_t& state) {
    const auto found = std::find_if(unit.states.begin(), unit.states.end(),
                                    [&](const State& one) { return text::equal_ignoring_case(one.name, name); });
    if (found != unit.states.end()) {
      state = static_cast<std::uint32_t>(found - unit.states.begin());
      return true;
    }
    const auto nearest = faults_.nearest(name, unit.states.size(),
                                         [&](std::size_t i) -> std::string_view { return unit.states[i].name; });
    lacks(unit, entry, given, description::missing("state " + ticked(name) + " of " + ticked(unit.path), nearest));
    return false;
  }

  bool find_operation(const Unit& unit, const TimesEntry& entry, const GivenTime& given, std::uint32_t& on) {
    const auto task = [&](std::size_t i) { return plant_.symbols[unit.operations[i]].reading.task(); };
    for (std::uint32_t i = 0; i < unit.operations.size(); ++i) {
      if (!text::equal_ignoring_case(task(i), given.of.on)) continue;
      on = i;
      return true;
    }
    const std::string_view nearest = faults_.nearest(given.of.on, unit.operations.size(), task);
    lacks(unit, entry, given,
          description::missing("operation " + ticked(given.of.on) + " of " + ticked(unit.path), nearest));
    return false;
  }

  void lacks(const Unit& unit, const TimesEntry& entry, const GivenTime& given, std::string message) {
    const Pointer here = pointer_of(entry, given);
    if (entry.exact) {
      faults_.add(here, std::move(message), FaultKind::unknown_name);
    } else {
      made_.lacks(here, unit.path, std::move(message));
    }
  }

  void report_no_transition(const Unit& unit, const TimesEntry& entry, const GivenTime& given) {
    std::vector<std::string> known;
    known.reserve(unit.transitions.size());
    for (const Transition& t : unit.transitions) {
      description::TimesKey key{unit.states[t.from].name, unit.states[t.to].name};
      if (!given.of.on.empty() && t.on != kNone) key.on = plant_.symbols[unit.operations[t.on]].reading.task();
      known.push_back(description::times_key_text(key));
    }
    const auto nearest =
        faults_.nearest(given.key, known.size(), [&](std::size_t i) -> std::string_view { return known[i]; });
    lacks(unit, entry, given,
          description::missing("transition " + ticked(given.key) + " of " + ticked(unit.path), nearest));
  }

  /// The most specific time of an entry for a transition; null if it has none. Marks all that it has as found.
  static const UnitTime* time_of(MatchedEntry& entry, std::uint32_t from, std::uint32_t to, std::uint32_t on) {
    const UnitTime* best = nullptr;
    for (const std::uint64_t code :
         {code_of(from, to, on), code_of(from, to, kNone), code_of(kNone, to, on), code_of(kNone, to, kNone)}) {
      const auto found = std::lower_bound(entry.times.begin(), entry.times.end(), code,
                                          [](const UnitTime& time, std::uint64_t value) { return time.code < value; });
      if (found == entry.times.end() || found->code != code) continue;
      found->found = true;
      if (best == nullptr) best = &*found;
    }
    return best;
  }

  void add_spring_returns(Unit& unit, std::vector<MatchedEntry>& matched) const {
    if (unit.actuation != tables::Actuation::spring) return;
    std::vector<Transition> returns;
    for (std::uint32_t from = 0; from < unit.states.size(); ++from) {
      const bool timed = std::any_of(matched.begin(), matched.end(), [&](MatchedEntry& entry) {
        return time_of(entry, from, unit.rest, kNone) != nullptr;
      });
      if (!timed || !returns_without_transition(unit, from)) continue;
      Transition transition;
      transition.from = from;
      transition.to = unit.rest;
      transition.takes = description::Duration::fixed(unit.travel);
      transition.origin = Origin::given;
      transition.spring_return = true;
      returns.push_back(transition);
    }
    const auto derived = std::find_if(unit.transitions.begin(), unit.transitions.end(),
                                      [](const Transition& t) { return t.origin != Origin::given; });
    unit.transitions.insert(derived, returns.begin(), returns.end());
  }

  void set_times(const Unit& unit, Transition& transition, std::vector<MatchedEntry>& matched) {
    const MatchedEntry* best_entry = nullptr;
    const UnitTime* best = nullptr;
    for (MatchedEntry& entry : matched) {
      const UnitTime* time = time_of(entry, transition.from, transition.to, transition.on);
      if (time == nullptr) continue;
      if (best == nullptr) {
        best = time;
        best_entry = &entry;
      } else if (best_entry->entry->literals == entry.entry->literals && best->given->text != time->given->text) {
        contradiction(unit, *best_entry->entry, pointer_of(*best_entry->entry, *best->given), *entry.entry,
                      pointer_of(*entry.entry, *time->given));
      }
    }
    if (best != nullptr) set_times(unit, transition, *best_entry->entry, *best->given);
  }

  void set_times(const Unit& unit, Transition& transition, const TimesEntry& entry, const GivenTime& given) {
    const Pointer here = pointer_of(entry, given);
    if (given.after && transition.spring_return) {
      faults_.add(here / "after",
                  "`after` is not allowed in the return of a spring, which has only `takes`; remove it");
      return;
    }
    const auto set = [&](description::Duration& time, const std::optional<description::Duration>& value,
                         std::string_view key) {
      if (!value) return;
      description::Duration own = *value;
      if (formulas_.resolve(unit, entry.given->device, here / key / "seconds", own)) time = own;
    };
    set(transition.after, given.after, "after");
    set(transition.takes, given.takes, "takes");
  }

  void set_overrun(Unit& unit, std::vector<MatchedEntry>& matched) {
    const bool held = unit.actuation == tables::Actuation::held;
    const TimesEntry* best = nullptr;
    for (const MatchedEntry& each : matched) {
      TimesEntry& entry = *each.entry;
      if (held) ++entry.held;
      if (!entry.given->overrun) continue;
      const Pointer here = pointer_of(*entry.given) / "overrun";
      if (!held && entry.exact) {
        faults_.add(here, ticked(unit.path) + " is `" + std::string(description::actuation_name(unit.actuation)) +
                              "`, but only a `held` device can overrun; remove `overrun`");
      } else if (held && best == nullptr) {
        best = &entry;
        unit.overrun = *entry.given->overrun;
      } else if (held && best->literals == entry.literals && *best->given->overrun != *entry.given->overrun) {
        contradiction(unit, *best, pointer_of(*best->given) / "overrun", entry, here);
      }
    }
  }

  void contradiction(const Unit& unit, const TimesEntry& first, const Pointer& at_first, const TimesEntry& second,
                     const Pointer& at_second) {
    description::DescriptionFault fault{at_second.text(),
                                        ticked(second.given->device) + " and " + ticked(first.given->device) +
                                            " are equally specific and give a time of " + ticked(unit.path) +
                                            " different values; make one more specific or name the device"};
    fault.kind = FaultKind::patterns;
    fault.at_key = true;
    fault.related = at_first.text();
    fault.related_message = "the other value";
    if (contradictions_.insert({fault.pointer, fault.related}).second) faults_.add(std::move(fault));
  }

  void report_patterns() {
    for (const TimesEntry* pattern : patterns_) {
      const GivenTimes& given = *pattern->given;
      if (pattern->matched == 0) {
        faults_.warn(pointer_of(given), ticked(given.device) + " matches no device", FaultKind::matches_nothing);
        continue;
      }
      for (const GivenTime& time : given.transitions) made_.takes(pointer_of(*pattern, time), pattern->matched);
      if (!given.overrun || pattern->held != 0) continue;
      faults_.add(pointer_of(given) / "overrun", "no device that " + ticked(given.device) +
                                                     " matches is `held`, and only such a device can overrun; "
                                                     "remove `overrun`");
    }
  }

  PlantModel& plant_;
  TimeFormulas& formulas_;
  MadeNames& made_;
  description::Faults& faults_;
  std::vector<TimesEntry> entries_;
  std::vector<TimesEntry*> patterns_;  ///< the most specific first, equal ones in the order of the description
  std::set<std::pair<std::string, std::string>> contradictions_;
};

}  // namespace

std::vector<std::string> resolve_times(PlantModel& plant, TimeFormulas& formulas, MadeNames& made,
                                       description::Faults& faults) {
  if (plant.description->times.empty()) return {};
  return TimesResolver(plant, formulas, made, faults).run();
}

}  // namespace symplant::model
