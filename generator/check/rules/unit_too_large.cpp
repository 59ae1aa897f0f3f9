// SP406 unit-too-large: a device has more symbols or states than a device may have.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kUnitTooLargePage =
    R"(A device has more than 64 operations, 64 events or 250 states. Most often the level of the name that should distinguish devices
is the same for all of them.

**What the model loses.** All its symbols are in no unit: no device drives them. They are still served.

**How to fix it.** Check the device level of the names.
)";

void check_unit_too_large(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::TooLarge& large : subject.evidence.too_large) {
    diagnostics.add(
        rule.info, {{device(large.path)}, {device(large.path)}, {}},
        fmt::format("`{}` has {} operations, {} events and {} states, and a device at most {}, {} and {}: its "
                    "symbols are in no device; check whether the device level of their names distinguishes devices",
                    large.path, large.operations, large.events, large.states, tables::kMaxOperations,
                    tables::kMaxEvents, tables::kMaxStates),
        location_of(plant, plant.symbols[large.symbols.front()]));
  }
}

}  // namespace

const Rule kUnitTooLarge{
    {"SP406", "unit-too-large", diag::Severity::warning, "a device has more symbols or states than a device may have",
     kUnitTooLargePage, diag::Rank::row},
    check_unit_too_large};

}  // namespace symplant::check
