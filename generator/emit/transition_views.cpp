// The views of a type's d_ext, d_int, times and guards.
#include "emit/transition_views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "emit/encode.hpp"
#include "emit/model_text.hpp"
#include "symplant/tables/names.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
namespace {

using tables::Transition;

/// A type with more states than this has a rule for an operation that leads from every other state to one.
constexpr std::size_t kStatesWithoutRules = 3;
/// tables::Moves holds this many moves if its class does not say otherwise.
constexpr std::size_t kUsualMoves = 4;

View item(std::initializer_list<std::pair<const std::string, std::string>> texts) { return {{texts}, {}}; }

/// A list of one item, or of none: what a template asks to decide.
void add_flag(View& view, const std::string& list, bool set) {
  view.lists[list];
  if (set) view.lists[list].emplace_back();
}

/// `1500 * kMillisecond`.
std::string time_text(tables::Time time) {
  constexpr std::array<std::pair<tables::Time, const char*>, 4> kUnits{{{tables::kSecond, "kSecond"},
                                                                        {tables::kMillisecond, "kMillisecond"},
                                                                        {tables::kMicrosecond, "kMicrosecond"},
                                                                        {tables::kNanosecond, "kNanosecond"}}};
  for (const auto& [unit, name] : kUnits) {
    if (time % unit == 0) return fmt::format("{} * {}", time / unit, name);
  }
  return "0";
}

/// `1500 ms`, for a comment.
std::string time_words(tables::Time time) {
  std::string text = time_text(time);
  for (const auto& [name, unit] : {std::pair("kSecond", "s"), {"kMillisecond", "ms"}, {"kMicrosecond", "us"}}) {
    if (text.ends_with(name)) return fmt::format("{} {}", text.substr(0, text.find(' ')), unit);
  }
  return fmt::format("{} ns", time);
}

/// The order in which row_of() numbers transitions of equal priority.
auto place_of(const Transition& t) {
  const int kind = t.on == tables::kSpringReturn ? 2 : t.on == tables::kNoOperation ? 1 : 0;
  return std::tuple(kind, t.to, t.from, t.on);
}

class TransitionViews {
 public:
  TransitionViews(View& view, const lower::Type& type, const Enumerators& names,
                  const std::vector<std::uint32_t>& devices, const lower::EngineTables& tables,
                  const model::PlantModel& plant)
      : view_(view),
        type_(type),
        unit_(plant.units[type.example]),
        names_(names),
        devices_(devices),
        tables_(tables),
        plant_(plant) {}

  void add() {
    name_guards();
    name_times();
    set_priorities();
    for (std::size_t n = 0; n < type_.transitions.size(); ++n) {
      add_transition(n);
      moves_[{type_.transitions[n].from, type_.transitions[n].on}].push_back(n);
    }
    add_rules();
    for (const char* list : {"commanded_states", "automatic_states", "spring_states"}) view_.lists[list];
    for (std::uint8_t s = 0; s < type_.states; ++s) add_state(s);
    const bool ruled = !view_.lists["operation_rules"].empty();
    const bool cased = !view_.lists["commanded_states"].empty();
    add_flag(view_, "commanded", ruled || cased);
    add_flag(view_, "by_rules", ruled);
    add_flag(view_, "by_states", cased);
    add_flag(view_, "automatic", !view_.lists["automatic_states"].empty());
    add_flag(view_, "spring", !view_.lists["spring_states"].empty());
    view_.texts["moves_size"] = most_ > kUsualMoves ? fmt::format(", {}", most_) : "";
  }

 private:
  const std::string& state(std::uint8_t number) const { return names_.states[number]; }

  // A guard is named by the target of the first transition that has it: to_RUN2, or IDLE1_to_RUN2 if others lead there;
  // moving_to_RUN2 if it is the `while` of that transition.
  void name_guards() {
    text::IdentifierScope scope;
    auto& guards = view_.lists["guards"];
    const std::size_t count = unit_.has_behaviour() ? unit_.first_input : unit_.conditions.size();
    std::vector<const Transition*> first(count);
    std::map<std::uint8_t, std::set<std::uint16_t>> leading;  // to a state: the guards
    for (const Transition& t : type_.transitions) {
      for (const std::uint16_t guard : {t.when, t.during}) {
        if (guard == tables::kNoCondition) continue;
        if (guard < count && first[guard] == nullptr) first[guard] = &t;
        leading[t.to].insert(guard);
      }
    }
    for (std::uint16_t g = 0; g < count; ++g) {
      std::string name = "unused";
      if (const Transition* t = first[g]) {
        name = (leading[t->to].size() == 1 ? "" : state(t->from) + "_") + "to_" + state(t->to);
        if (t->when != g) name.insert(0, "moving_");
      }
      guards_.push_back(scope.unique(name));
      std::string text = short_condition_text(unit_.conditions[g], plant_);
      guards.push_back(item({{"enumerator", guards_.back()},
                             {"number", std::to_string(g)},
                             {"condition", comment_text(text)},
                             {"of", devices_.size() == 1 ? "" : comment_text(fmt::format(" (of {})", unit_.path))}}));
    }
    add_flag(view_, "guarded", !guards.empty());
  }

  // A time is named by its target; if several times lead to a state, all but the most frequent also by the source.
  void name_times() {
    std::map<std::pair<std::uint8_t, std::uint16_t>, std::size_t> uses;
    for (const Transition& t : type_.transitions) ++uses[{t.to, t.dt}];
    std::map<std::uint8_t, std::pair<std::size_t, std::uint16_t>> most;  // of a state: uses, dt
    for (const auto& [key, count] : uses) {
      auto& best = most[key.first];
      if (count > best.first) best = {count, key.second};
    }
    text::IdentifierScope scope;
    for (const Transition& t : type_.transitions) {
      const auto [found, added] = times_.try_emplace({t.to, t.dt});
      if (!added) continue;
      const bool usual = most[t.to].second == t.dt;
      found->second = scope.unique(usual ? "dt_to_" + state(t.to) : "dt_" + state(t.from) + "_to_" + state(t.to));
      add_time(found->second, t.dt);
    }
    view_.lists["times"];
    if (unit_.actuation == tables::Actuation::spring || unit_.has_behaviour()) {
      add_time("dt_without_command", type_.travel);
    }
    view_.lists["returns"];
    if (unit_.actuation == tables::Actuation::spring) {
      View back = item({{"to", state(type_.rest)}, {"to_number", std::to_string(type_.rest)}});
      add_milliseconds(back, type_.travel);
      view_.lists["returns"].push_back(std::move(back));
    }
  }

  /// The times of the type's first device.
  const tables::TransitionTimes& times_of(std::uint16_t dt) const {
    if ((dt & tables::kOfDevice) == 0) return type_.times[dt];
    return tables_.times[tables_.units[type_.example].times + static_cast<std::uint32_t>(dt ^ tables::kOfDevice)];
  }

  /// A time in ms, for other languages; the mean of a random time; 0 for one that a formula gives.
  std::string milliseconds(tables::Time time) const {
    if (time < 0) {
      const tables::RandomTime& row = tables_.random_times[static_cast<std::size_t>(-1 - time)];
      time = row.kind == tables::RandomTime::Kind::uniform   ? row.a + (row.b - row.a) / 2
             : row.kind == tables::RandomTime::Kind::seconds ? 0
                                                             : row.a;
    }
    std::string text = fmt::format("{}.{:06}", time / tables::kMillisecond, time % tables::kMillisecond);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }
  void add_milliseconds(View& view, std::uint16_t dt) const {
    view.texts["after_ms"] = milliseconds(times_of(dt).after);
    view.texts["takes_ms"] = milliseconds(times_of(dt).takes);
  }

  void add_time(const std::string& name, std::uint16_t dt) {
    View view = item({{"dt", name}, {"note", ""}});
    add_milliseconds(view, dt);
    if ((dt & tables::kOfDevice) != 0) {
      const auto index = static_cast<std::uint32_t>(dt ^ tables::kOfDevice);
      const bool timed = std::any_of(devices_.begin(), devices_.end(), [&](std::uint32_t unit) {
        const tables::TransitionTimes& times = tables_.times[tables_.units[unit].times + index];
        return times.after != 0 || times.takes < 0;
      });
      view.texts["value"] = fmt::format(" = {}({})", timed ? "own_dt" : "own_travel", index);
      view.texts["note"] = "  // each device has its own: kTimes in tables_gen.cpp";
    } else {
      const auto expression = [](tables::Time time) {
        return time < 0 ? fmt::format("random_time({})", -1 - time) : time_text(time);
      };
      const tables::TransitionTimes& times = type_.times[dt];
      std::string value;
      if (times.after != 0) value += ".after = " + expression(times.after);
      if (times.takes != 0) value += (value.empty() ? "" : ", ") + (".takes = " + expression(times.takes));
      view.texts["value"] = "{" + value + "}";
      std::string& note = view.texts["note"];
      for (const tables::Time time : {times.after, times.takes}) {
        if (time < 0) note += (note.empty() ? "  // " : ", then ") + random_text(time);
      }
    }
    view_.lists["times"].push_back(std::move(view));
  }

  std::string random_text(tables::Time time) const {
    const tables::RandomTime& row = tables_.random_times[static_cast<std::size_t>(-1 - time)];
    if (row.kind == tables::RandomTime::Kind::seconds) {
      const auto texts = tables::split_names(tables_.values.formula_texts);
      return fmt::format("({}) s", texts[static_cast<std::size_t>(row.a)]);
    }
    if (row.kind == tables::RandomTime::Kind::uniform) {
      return fmt::format("uniform, {} to {}", time_words(row.a), time_words(row.b));
    }
    return fmt::format("normal, mean {}, standard deviation {}", time_words(row.a), time_words(row.b));
  }

  /// A run of transitions in the order of row_of() has one priority, the last run has none.
  void set_priorities() {
    priorities_.assign(type_.transitions.size(), 0);
    for (std::size_t n = 1; n < priorities_.size(); ++n) {
      const bool in_order = place_of(type_.transitions[n - 1]) <= place_of(type_.transitions[n]);
      priorities_[n] = priorities_[n - 1] + (in_order ? 0 : 1);
    }
  }
  bool has_priority(std::size_t n) const { return priorities_[n] != priorities_.back(); }

  /// `go(State::P2, dt_to_P2).when(Guard::to_P2)`
  std::string go(std::size_t n) const {
    const Transition& t = type_.transitions[n];
    std::string text = fmt::format("go(State::{}, {})", state(t.to), times_.at({t.to, t.dt}));
    if (t.when != tables::kNoCondition) text += fmt::format(".when(Guard::{})", guards_[t.when]);
    if (t.during != tables::kNoCondition) text += fmt::format(".during(Guard::{})", guards_[t.during]);
    for (const tables::TransitionNumber& number : tables::kTransitionNumbers) {
      const std::uint32_t value = t.numbers.*number.member;
      if (value != 0) text += fmt::format(".{}({})", number.key, value);
    }
    if (t.once) text += ".once()";
    if (has_priority(n)) text += fmt::format(".priority({})", priorities_[n]);
    return text;
  }
  std::string go(const std::vector<std::size_t>& moves) {
    most_ = std::max(most_, moves.size());
    if (moves.size() == 1) return go(moves.front());
    std::string text;
    for (const std::size_t n : moves) text += (text.empty() ? "{" : ", ") + go(n);
    return text + "}";
  }

  void add_transition(std::size_t n) {
    const Transition& t = type_.transitions[n];
    const bool commanded = t.on < tables::kMaxOperations;
    View view = item({{"number", std::to_string(n)},
                      {"from", state(t.from)},
                      {"from_number", std::to_string(t.from)},
                      {"to", state(t.to)},
                      {"to_number", std::to_string(t.to)},
                      {"dt", times_.at({t.to, t.dt})},
                      {"about", comment_text(transition_text(t, unit_, plant_))},
                      {"priority", has_priority(n) ? std::to_string(priorities_[n]) : ""}});
    add_milliseconds(view, t.dt);
    for (const char* list : {"by_operation", "by_itself", "by_spring", "guard"}) view.lists[list];
    if (commanded) view.lists["by_operation"].push_back(item({{"operation", names_.operations[t.on]}}));
    add_flag(view, "by_itself", t.on == tables::kNoOperation);
    add_flag(view, "by_spring", t.on == tables::kSpringReturn);
    add_flag(view, "once", t.once);
    if (t.when != tables::kNoCondition) {
      view.lists["guard"].push_back(item({{"enumerator", guards_[t.when]}, {"number", std::to_string(t.when)}}));
    }
    view_.lists["states"][t.from].lists["leaving"].push_back(view);
    view_.lists["transitions"].push_back(std::move(view));
  }

  /// Operations that lead from every other state to one, all with the same time and guard.
  void add_rules() {
    view_.lists["operation_rules"];
    view_.lists["transitions"];
    for (View& state : view_.lists["states"]) state.lists["leaving"];
    if (type_.states <= kStatesWithoutRules) return;
    for (std::uint8_t x = 0; x < type_.operations; ++x) {
      std::vector<std::size_t> moves;
      for (std::uint8_t s = 0; s < type_.states; ++s) {
        const auto found = moves_.find({s, x});
        if (found != moves_.end()) moves.insert(moves.end(), found->second.begin(), found->second.end());
      }
      if (moves.size() != type_.states - 1U) continue;
      const std::uint8_t to = type_.transitions[moves.front()].to;
      const std::string first = go(moves.front());
      bool one = moves_.find({to, x}) == moves_.end();
      for (const std::size_t n : moves) one = one && go(n) == first;
      for (std::uint8_t s = 0; one && s < type_.states; ++s) one = s == to || moves_.at({s, x}).size() == 1;
      if (!one) continue;
      view_.lists["operation_rules"].push_back(
          item({{"operation", names_.operations[x]}, {"to", state(to)}, {"go", first}}));
      for (std::uint8_t s = 0; s < type_.states; ++s) moves_.erase({s, x});
    }
  }

  void add_state(std::uint8_t s) {
    View commanded = item({{"state", state(s)}});
    for (std::uint8_t x = 0; x < type_.operations; ++x) {
      const auto found = moves_.find({s, x});
      if (found == moves_.end()) continue;
      commanded.lists["moves"].push_back(item({{"operation", names_.operations[x]}, {"go", go(found->second)}}));
    }
    if (!commanded.lists.empty()) view_.lists["commanded_states"].push_back(std::move(commanded));
    const auto add = [&](const char* list, std::uint8_t on) {
      const auto found = moves_.find({s, on});
      if (found == moves_.end()) return;
      view_.lists[list].push_back(item({{"state", state(s)}, {"go", go(found->second)}}));
    };
    add("automatic_states", tables::kNoOperation);
    add("spring_states", tables::kSpringReturn);
  }

  View& view_;
  const lower::Type& type_;
  const model::Unit& unit_;
  const Enumerators& names_;
  const std::vector<std::uint32_t>& devices_;
  const lower::EngineTables& tables_;
  const model::PlantModel& plant_;
  std::vector<std::string> guards_;
  std::map<std::pair<std::uint8_t, std::uint16_t>, std::string> times_;  ///< by target and Transition::dt
  std::vector<std::size_t> priorities_;
  std::map<std::pair<std::uint8_t, std::uint8_t>, std::vector<std::size_t>> moves_;  ///< by source and cause
  std::size_t most_ = 0;
};

}  // namespace

void add_transitions(View& view, const lower::Type& type, const Enumerators& names,
                     const std::vector<std::uint32_t>& devices, const lower::EngineTables& tables,
                     const model::PlantModel& plant) {
  TransitionViews(view, type, names, devices, tables, plant).add();
}

}  // namespace symplant::emit
