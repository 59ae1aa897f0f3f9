// SP410 initial-by-row-order: only the order of rows decides where a device starts.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInitialByRowOrderPage =
    R"(Neither an Initial TRUE, nor a rest state, nor a sequence number determines the state in which a device starts. It starts in the
state whose symbol comes first in the list.

**What the model loses.** The device may start at the wrong end. Then the PLC sees an input on that should be off.

**How to fix it.** Write Initial TRUE for the event that is on when the plant starts, number the tasks, or give `initial` in
plant.json.
)";

/// The device, and the events whose Initial could decide.
diag::Subjects about_start(const model::PlantModel& plant, const model::Unit& unit) {
  diag::Subjects subjects = about(unit).following(device(unit.path)).following(model_of(unit.path));
  for (const std::uint32_t event : unit.events) subjects.follows.push_back(symbol_named(plant.symbols[event].name()));
  return subjects;
}

void check_initial_by_row_order(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    // Without an event there is nothing to write TRUE with; SP408 reports several that are TRUE.
    if (unit.initial_from != model::InitialFrom::row_order || unit.events.empty()) continue;
    if (evidence_of(subject, unit).initial_candidates > 1) continue;
    diagnostics.add(rule.info, about_start(plant, unit),
                    fmt::format("`{}` starts in `{}`, only because its row comes first: {}", unit.path,
                                unit.states[unit.initial].name,
                                has_description(plant) ? "give `initial` in plant.json"
                                                       : "write Initial TRUE for the event that is on then"),
                    unit.described == nullptr ? location_of(plant, first_symbol_of(plant, unit))
                                              : described_location(plant, unit, entry_pointer(unit)));
  }
}

}  // namespace

const Rule kInitialByRowOrder{{"SP410", "initial-by-row-order", diag::Severity::note,
                               "only the order of rows decides where a device starts", kInitialByRowOrderPage},
                              check_initial_by_row_order};

}  // namespace symplant::check
