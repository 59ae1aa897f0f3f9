// SP416 tasks-look-parallel: several tasks of one device are probably on at the same time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "check/rules.hpp"
#include "model/sequence.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTasksLookParallelPage =
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
)";

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
      const std::string task = text::to_upper(plant.symbols[symbol].reading.task);
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

const Rule kTasksLookParallel{{"SP416", "tasks-look-parallel", diag::Severity::warning,
                               "several tasks of one device look parallel", kTasksLookParallelPage, diag::Rank::words},
                              check_tasks_look_parallel};

}  // namespace symplant::check
