// SP410 initial-by-row-order: only the order of rows decides where a device starts.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInitialByRowOrderPage =
    R"(Neither an Initial TRUE, nor a rest state, nor a sequence number determines the state in which a device starts. It starts in the
state whose symbol comes first in the list. If more than a third of a list's devices start like that, there is one finding for
the list: it has no initial values.

**What the model loses.** The device may start at the wrong end. Then the PLC sees an input on that should be off.

**How to fix it.** Write Initial TRUE for the event that is on when the plant starts, number the tasks, or give `initial` in
plant.json.
)";

/// Fewer devices of a list get a finding each.
constexpr std::size_t kFewestOfOneCause = 4;
constexpr std::size_t kShareOfOneCause = 3;  ///< one of 3
constexpr std::size_t kStartsNamed = 3;

/// Without an event there is nothing to write TRUE with; SP408 reports several that are TRUE.
bool starts_by_row_order(const Subject& subject, const model::Unit& unit) {
  return unit.initial_from == model::InitialFrom::row_order && !unit.events.empty() &&
         evidence_of(subject, unit).initial_candidates <= 1;
}

/// The devices of one list.
struct Starts {
  std::size_t devices = 0;
  std::vector<const model::Unit*> by_row_order = {};

  bool is_one_cause() const {
    return by_row_order.size() >= kFewestOfOneCause && by_row_order.size() * kShareOfOneCause > devices;
  }
};

std::vector<Starts> starts_by_list(const Subject& subject) {
  std::vector<Starts> lists(subject.plant.lists.size());
  for (const model::Unit& unit : subject.plant.units) {
    Starts& starts = lists[first_symbol_of(subject.plant, unit).list];
    ++starts.devices;
    if (starts_by_row_order(subject, unit)) starts.by_row_order.push_back(&unit);
  }
  return lists;
}

/// The device, and the events whose Initial could decide.
diag::Subjects about_start(const model::PlantModel& plant, const model::Unit& unit) {
  diag::Subjects subjects = about(unit).following(device(unit.path)).following(model_of(unit.path));
  for (const std::uint32_t event : unit.events) subjects.follows.push_back(symbol_named(plant.symbols[event].name()));
  return subjects;
}

std::string_view advice(const model::PlantModel& plant) {
  return has_description(plant) ? "give `initial` in plant.json" : "write Initial TRUE for the event that is on then";
}

std::string start_text(const model::Unit& unit) {
  return fmt::format("`{}` in `{}`", unit.path, unit.states[unit.initial].name);
}

void report_list(const Rule& rule, const model::PlantModel& plant, const Starts& starts,
                 diag::Diagnostics& diagnostics) {
  const model::Symbol& first = first_symbol_of(plant, *starts.by_row_order.front());
  std::string examples;
  for (std::size_t i = 0; i < kStartsNamed; ++i) {
    examples += (examples.empty() ? "" : ", ") + start_text(*starts.by_row_order[i]);
  }
  diagnostics.add(
      rule.info,
      fmt::format("{} of {} devices of `{}` start in a state only because its row comes first, such as {}: {}",
                  starts.by_row_order.size(), starts.devices, plant.lists[first.list].name(), examples, advice(plant)),
      location_of(plant, first));
}

void check_initial_by_row_order(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const Starts& starts : starts_by_list(subject)) {
    if (starts.is_one_cause()) {
      report_list(rule, plant, starts, diagnostics);
      continue;
    }
    for (const model::Unit* unit : starts.by_row_order) {
      diagnostics.add(rule.info, about_start(plant, *unit),
                      fmt::format("`{}` starts in `{}`, only because its row comes first: {}", unit->path,
                                  unit->states[unit->initial].name, advice(plant)),
                      unit->described == nullptr ? location_of(plant, first_symbol_of(plant, *unit))
                                                 : described_location(plant, *unit, entry_pointer(*unit)));
    }
  }
}

}  // namespace

const Rule kInitialByRowOrder{{"SP410", "initial-by-row-order", diag::Severity::note,
                               "only the order of rows decides where a device starts", kInitialByRowOrderPage},
                              check_initial_by_row_order};

}  // namespace symplant::check
