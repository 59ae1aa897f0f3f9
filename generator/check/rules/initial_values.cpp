// Rules: initial values and states.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "check/rules.hpp"
#include "model/classify.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

void check_initial_not_understood(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.initial_known) continue;
    diagnostics.add(rule.info, about(symbol).explaining(symbol_named(symbol.name())),
                    fmt::format("`{}` is not a value of type {}: `{}` starts {}; correct it or leave it empty",
                                symbol.row->initial, model::data_type_name(symbol.type), symbol.name(),
                                symbol.type == tables::DataType::boolean ? "off" : "at 0"),
                    location_of(plant, *symbol.row, symbol.row->initial));
  }
}

void check_operation_initial_ignored(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.direction != tables::Direction::operation || symbol.type != tables::DataType::boolean) continue;
    if (symbol.initial == 0) continue;
    diagnostics.add(rule.info, about(symbol).following(address_of(symbol.name())),
                    fmt::format("`{}` has Initial TRUE and still starts off: the PLC writes operations", symbol.name()),
                    location_of(plant, *symbol.row, symbol.row->initial));
  }
}

/// Else it only reports, as the description says, and starts as its Initial has it.
bool is_state(const model::Unit& unit, const model::Symbol& symbol) {
  return std::any_of(unit.states.begin(), unit.states.end(), [&](const model::State& state) {
    return text::equal_ignoring_case(state.name, symbol.reading.task());
  });
}

void check_initial_ambiguous(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (evidence_of(subject, unit).initial_candidates < 2) continue;
    std::vector<diag::Related> others;
    const model::Symbol* first = nullptr;
    for (const std::uint32_t index : unit.events) {
      const model::Symbol& symbol = plant.symbols[index];
      if (symbol.initial == 0 || !is_state(unit, symbol)) continue;
      if (first == nullptr) {
        first = &symbol;
      } else {
        others.push_back({location_of(plant, *symbol.row, symbol.row->initial), "TRUE here as well"});
      }
    }
    if (first == nullptr) continue;  // never: the candidates are among the events
    diagnostics.add(
        rule.info, about(*first),
        fmt::format(
            "{} events of `{}` are TRUE at the start, so they are ignored: it starts in `{}`; keep TRUE for one",
            evidence_of(subject, unit).initial_candidates, unit.path, unit.states[unit.initial].name),
        location_of(plant, *first->row, first->row->initial), std::move(others));
  }
}

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

const Rule kInitialNotUnderstood{
    {"SP310", "initial-not-understood", diag::Severity::warning, "an initial value cannot be read",
     R"(The Initial cell of a symbol is not a value of its type. BOOL takes TRUE or FALSE (or 1, 0). Numbers are written like 5, -3,
16#1F, K5, H1F or 1.5, and must fit their type.

**What the model loses.** The symbol starts off, or at 0. If its value decides in which state a device starts, the device starts
in another one.

**How to fix it.** Correct the cell, or leave it empty.
)",
     diag::Rank::value},
    check_initial_not_understood};

const Rule kOperationInitialIgnored{
    {"SP311", "operation-initial-ignored", diag::Severity::note, "an operation has an initial value",
     R"(An operation (a PLC output) of type BOOL has Initial TRUE. The PLC writes operations: in the plant they start off until a PLC, a
scenario or a person sets them.

**What the model loses.** Nothing, if the PLC writes its outputs as usual.

**How to fix it.** Nothing to do.
)"},
    check_operation_initial_ignored};

const Rule kInitialAmbiguous{
    {"SP408", "initial-ambiguous", diag::Severity::warning, "several events of a device are on at the start",
     R"(Several events of one device have Initial TRUE, but a device starts in one state.

**What the model loses.** None of them counts: the device starts in its rest state, or otherwise in the first of its states.

**How to fix it.** Keep Initial TRUE for the one event that is on when the plant starts, or give `initial` in plant.json.
)"},
    check_initial_ambiguous};

const Rule kInitialByRowOrder{
    {"SP410", "initial-by-row-order", diag::Severity::note, "only the order of rows decides where a device starts",
     R"(Neither an Initial TRUE, nor a rest state, nor a sequence number determines the state in which a device starts. It starts in the
state whose symbol comes first in the list. If more than a third of a list's devices start like that, there is one finding for
the list: it has no initial values.

**What the model loses.** The device may start at the wrong end. Then the PLC sees an input on that should be off.

**How to fix it.** Write Initial TRUE for the event that is on when the plant starts, number the tasks, or give `initial` in
plant.json.
)"},
    check_initial_by_row_order};

}  // namespace symplant::check
