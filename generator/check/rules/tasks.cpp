// Rules: tasks of a device.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "check/rules.hpp"
#include "check/spelling/bent_words.hpp"
#include "check/spelling/device_classes.hpp"
#include "model/sequence.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

/// A task of a unit that has an operation, and one that has an event.
struct WordPair {
  std::uint32_t commanded;
  std::uint32_t reported;
};

/// The two symbols. If both words mean one state, neither of the symbols that the two tasks lack is missing.
diag::Subjects about_pair(const model::PlantModel& plant, const model::Unit& unit, WordPair pair) {
  const model::State& commanded = unit.states[pair.commanded];
  const model::State& reported = unit.states[pair.reported];
  diag::Subjects subjects =
      about(event_of(plant, unit, reported.event), operation_of(plant, unit, commanded.operation));
  subjects.explains = {missing(plant, unit.path, tables::Direction::event, commanded.name),
                       missing(plant, unit.path, tables::Direction::operation, reported.name), model_of(unit.path)};
  subjects.follows = subjects.explains;
  subjects.follows.push_back(device(unit.path));
  return subjects;
}

void report(const Rule& rule, const model::PlantModel& plant, const model::Unit& unit, WordPair pair,
            diag::Diagnostics& diagnostics) {
  const model::Symbol& operation = operation_of(plant, unit, unit.states[pair.commanded].operation);
  const model::Symbol& event = event_of(plant, unit, unit.states[pair.reported].event);
  diagnostics.add(
      rule.info, about_pair(plant, unit, pair),
      fmt::format("`{}` and `{}`: do `{}` and `{}` mean the same state? spell them the same, or `{}` is never reported",
                  operation.name(), event.name(), operation.reading.task(), event.reading.task(), event.reading.task()),
      location_of(plant, event), {{location_of(plant, operation), "the operation"}});
}

/// A state that is reported and not commanded, nor led to by anything but its number.
bool is_only_reported(const model::Unit& unit, std::uint32_t state) {
  const model::State& of = unit.states[state];
  return of.event != model::kNone && of.operation == model::kNone && state != unit.rest &&
         std::none_of(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& transition) {
           return transition.to == state && transition.origin != model::Origin::inferred;
         });
}

/// Of a device with further tasks: forms of one word.
void report_bent_words(const Rule& rule, const model::PlantModel& plant, const model::Unit& unit,
                       diag::Diagnostics& diagnostics) {
  if (unit.operations.empty() || unit.events.empty() || unit.states.size() < 2) return;
  if (unit.has_behaviour() || !unit.outputs.empty()) return;  // other events may report the state
  for (std::uint32_t c = 0; c < unit.states.size(); ++c) {
    const model::State& commanded = unit.states[c];
    if (commanded.operation == model::kNone || commanded.event != model::kNone) continue;
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      if (!is_only_reported(unit, s) || !bent_alike(commanded.name, unit.states[s].name)) continue;
      report(rule, plant, unit, {c, s}, diagnostics);
      break;
    }
  }
}

/// Whether siblings have the other side of a word: SP414 reports what is missing.
bool are_two_states(const Subject& subject, const model::Unit& unit) {
  const auto location = static_cast<std::uint32_t>(&unit - subject.plant.units.data());
  return std::any_of(unit.states.begin(), unit.states.end(), [&](const model::State& state) {
    const bool commanded = state.operation != model::kNone;
    const auto other = commanded ? tables::Direction::event : tables::Direction::operation;
    return subject.classes.expects(location, other, state.name, false) == Expected::yes;
  });
}

void check_two_words_one_state(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (is_one_word_twice(subject, unit)) {
      if (are_two_states(subject, unit)) continue;
      const std::uint32_t commanded = unit.states[0].operation != model::kNone ? 0 : 1;
      report(rule, plant, unit, {commanded, 1 - commanded}, diagnostics);
    } else {
      report_bent_words(rule, plant, unit, diagnostics);
    }
  }
}

void check_task_claimed_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const TaskClaim& claim : task_claims(plant)) {
    const model::Symbol& symbol = plant.symbols[claim.overruled];
    const model::Symbol& other = plant.symbols[claim.other];
    const std::string_view direction = direction_text(symbol.direction);
    diagnostics.add(
        rule.info,
        about(symbol)
            .explaining(device(symbol.reading.device_path()))
            .explaining(address_of(symbol.name()))
            .following(address_of(symbol.name())),
        claim.other_dropped
            ? fmt::format("`{}` is an {} by its address `{}`, and takes the task from `{}`, which is in no device now: "
                          "correct its name or its address",
                          symbol.name(), direction, symbol.address_cell(), other.name())
            : fmt::format("`{}` is an {} by its address `{}`, and `{}` has that task already, so that it is in no "
                          "device: correct its name or its address",
                          symbol.name(), direction, symbol.address_cell(), other.name()),
        location_of(plant, *symbol.row, symbol.address_cell()),
        {{location_of(plant, other), "the symbol that has the task by its name"}});
  }
}

/// Words in tasks that name bits next to each other.
constexpr auto kParallelWords = std::to_array<std::string_view>(
    {"INTERLOCK", "INTLK", "ILOCK", "MUTUAL", "PROGRAM", "PROG", "PRG", "PGM", "ECHO", "SELECT"});
constexpr std::size_t kLeastSeries = 3;  ///< numbers on both sides
constexpr std::size_t kLeastTasks = 4;   ///< a device of fewer tasks is simple enough to have one state at a time

/// The tasks of a device that are equal but for the number at their end.
struct TaskSeries {
  std::set<std::string> operations;  ///< numbers; empty text: the task without a number
  std::set<std::string> events;
  std::uint32_t first_symbol = model::kNone;

  std::size_t size() const { return std::max(operations.size(), events.size()); }
  bool on_both_sides() const {
    const auto has = [&](const std::string& number) { return events.contains(number); };
    return static_cast<std::size_t>(std::count_if(operations.begin(), operations.end(), has)) >= kLeastSeries;
  }
};

bool has_parallel_word(std::string_view stem) {
  return std::any_of(kParallelWords.begin(), kParallelWords.end(),
                     [&](std::string_view word) { return stem.find(word) != std::string_view::npos; });
}

std::map<std::string, TaskSeries> series_of(const model::PlantModel& plant, const model::Unit& unit) {
  std::map<std::string, TaskSeries> all;
  for (const auto* side : {&unit.operations, &unit.events}) {
    for (const std::uint32_t symbol : *side) {
      const std::string task = text::to_upper(plant.symbols[symbol].reading.task());
      const std::size_t stem = task.find_last_not_of("0123456789") + 1;
      TaskSeries& series = all[task.substr(0, stem)];
      (side == &unit.operations ? series.operations : series.events).insert(task.substr(stem));
      series.first_symbol = std::min(series.first_symbol, symbol);
    }
  }
  return all;
}

/// "`INTERLOCK1` to `INTERLOCK8`", or one name.
std::string series_text(const std::string& stem, const TaskSeries& series) {
  const std::set<std::string>& numbers = series.operations.empty() ? series.events : series.operations;
  const auto by_value = [](const std::string& a, const std::string& b) {
    return model::compare_sequence(model::sequence_number(a), model::sequence_number(b)) < 0;
  };
  const std::string& least = *std::min_element(numbers.begin(), numbers.end(), by_value);
  const std::string& most = *std::max_element(numbers.begin(), numbers.end(), by_value);
  return least == most ? fmt::format("`{}{}`", stem, least) : fmt::format("`{0}{1}` to `{0}{2}`", stem, least, most);
}

void check_tasks_look_parallel(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (unit.operations.size() + unit.events.size() < kLeastTasks || unit.has_behaviour()) continue;
    const auto all = series_of(plant, unit);
    const std::pair<const std::string, TaskSeries>* best = nullptr;
    for (const auto& series : all) {
      const bool numbered = series.second.on_both_sides() && all.size() > 2;
      const bool named = has_parallel_word(series.first) && (series.second.size() > 1 || all.size() > 2);
      if (!numbered && !named) continue;
      if (best == nullptr || series.second.size() > best->second.size()) best = &series;
    }
    if (best == nullptr) continue;
    const model::Symbol& symbol = plant.symbols[best->second.first_symbol];
    const std::string x = best->second.size() > 1 ? best->first + "{x}" : best->first;
    diagnostics.add(
        rule.info,
        about(unit).explaining(model_of(unit.path)).explaining(sequence_of(unit.path)).following(device(unit.path)),
        fmt::format("{} tasks of `{}` look parallel, such as {}, but a device has one state at a time; part them by a "
                    "naming rule with the archetype {{ \"name\": \"{}\", \"model\": \"mirror\", \"operation\": \"{}\", "
                    "\"event\": \"{}\" }}",
                    unit.states.size(), unit.path, series_text(best->first, best->second), text::to_lower(best->first),
                    x, x),
        location_of(plant, symbol));
  }
}

}  // namespace

const Rule kTwoWordsOneState{
    {"SP405", "two-words-one-state", diag::Severity::warning, "two words may mean one state",
     R"(One task of a device has only an operation, another only an event, and they look like two forms of one word: `O_CLAMP` and
`I_CLAMPED`. Other tasks of the device have their own findings.

**What the model loses.** If both words mean one state, the device has one state too many: it goes to CLAMP, and CLAMPED never
comes on. A program that waits for it waits forever.

**How to fix it.** Spell both alike (`O_CLAMP`, `I_CLAMP`). If they are two states, add the operation or the event that is
missing.
)",
     diag::Rank::words},
    check_two_words_one_state};

const Rule kTaskClaimedTwice{
    {"SP407", "task-claimed-twice", diag::Severity::warning, "two symbols of a device claim one task and direction",
     R"(Two symbols of one device have the same task and the same direction. Names are unique, so the direction of one of them comes
from an address that contradicts its name. The address counts, since it is wired.

**What the model loses.** The first row keeps the task. The other symbol is in no unit: it is still served, but it drives no
device, and no device drives it.

**How to fix it.** Correct the name or the address of one of them.
)",
     diag::Rank::direction},
    check_task_claimed_twice};

const Rule kTasksLookParallel{
    {"SP416", "tasks-look-parallel", diag::Severity::warning, "several tasks of one device look parallel",
     R"(Under the built-in naming rule all tasks of a device are its states, and a device has one state at a time. Tasks such as
`INTERLOCK1` to `INTERLOCK8`, `PROG1` to `PROG16` or `ECHO` are bits next to each other: several of them are on at once. The
finding names words that say so (interlock, program, echo, select, mutual), and numbered series that both operations and
events have, next to other tasks. A device of nothing but one series (`P1` to `P8`) is not reported: it is an axis with
positions.

**What the model loses.** Each operation of such a device leads to another state and switches the other events off. The
program sees interlocks drop that the real device keeps, and the plant reports conflicting operations.

**How to fix it.** Name each bit's device apart (`RBT1INT3` with the task `ON`), or give a naming rule that parts the device in
facets, one for each number:

```json
{ "symplant-naming": 1, "name": "robots",
  "rules": [ { "pattern": "{line}_{process}_{device}_{direction}_{task}" } ],
  "archetypes": [ { "name": "interlock", "model": "mirror", "operation": "INTERLOCK{x}", "event": "INTERLOCK{x}" } ] }
```

`symplant infer` proposes such a rule, and docs/naming.md explains it.
)",
     diag::Rank::words},
    check_tasks_look_parallel};

}  // namespace symplant::check
