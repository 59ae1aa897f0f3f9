// SP403 unit-without-events: a device gives no feedback.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kUnitWithoutEventsPage =
    R"(A device has operations and no event: a lamp, a horn, a motor without contacts.

**What the model loses.** Nothing, if the device is like that. It moves, and no input of the PLC reports it.

**How to fix it.** Nothing to do, unless its events have the name of another device.
)";

void check_unit_without_events(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (!unit.events.empty()) continue;
    diagnostics.add(rule.info, about_sides(plant, unit, about(unit)),
                    fmt::format("`{}` has operations and no event: no input of the PLC reports its state", unit.path),
                    location_of(plant, first_symbol_of(plant, unit)));
  }
}

}  // namespace

const Rule kUnitWithoutEvents{{"SP403", "unit-without-events", diag::Severity::note, "a device gives no feedback",
                               kUnitWithoutEventsPage, diag::Rank::sides},
                              check_unit_without_events};

}  // namespace symplant::check
