// SP414 shape-lacks-symbol: a device lacks a symbol that those named like it have.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "check/spelling/device_classes.hpp"
#include "check/spelling/odd_devices.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kShapeLacksSymbolPage =
    R"(Nearly all devices named like this one have the same operations and events, and this one lacks some of them. Names are alike
if they differ in digits only (`CLAMP1`, `CLAMP2`), in any process. At least three others and three quarters of all must have
the symbol. If more than one device in eight lacks it, and more than one, the difference counts as intended.

**What the model loses.** What the symbol is for: without its operation a state is never commanded, without its event it is
never reported, without its number a scenario or a requirement has nothing to set or to read. The device gets another type than
the others, for example a single solenoid.

**How to fix it.** Add the row, or spell its task as the others do. If the device is really different, ignore the finding in
plant.json, section `check`.
)";

/// The row next to the one that is missing: of the same task, or the device's first.
const model::Symbol& nearest_symbol(const Subject& subject, std::uint32_t device, std::string_view task) {
  const model::PlantModel& plant = subject.plant;
  if (device < plant.units.size()) {
    const model::Unit& unit = plant.units[device];
    for (const auto* side : {&unit.operations, &unit.events}) {
      for (const std::uint32_t s : *side) {
        if (text::equal_ignoring_case(plant.symbols[s].reading.task, task)) return plant.symbols[s];
      }
    }
  }
  return plant.symbols[subject.classes.first_symbol(device)];
}

void check_shape_lacks_symbol(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const OddDevice& odd : odd_devices(subject)) {
    if (odd.one_task) continue;  // SP413 reports it
    const Lacking& first = odd.lacks.front();
    std::vector<diag::Related> as_there;
    for (const Lacking& lacking : odd.lacks) {
      as_there.push_back({location_of(plant, *lacking.others), "one that has it"});
    }
    diagnostics.add(
        rule.info, about(odd),
        fmt::format("`{}`{} missing: {} of {} devices named like `{}` have it; add {}, or spell the task as "
                    "they do",
                    first.name,
                    odd.lacks.size() == 1 ? std::string(" is") : fmt::format(" and {} more are", odd.lacks.size() - 1),
                    first.having, odd.of, odd.path, odd.lacks.size() == 1 ? "the row" : "the rows"),
        location_of(plant, nearest_symbol(subject, odd.device, first.others->reading.task)), std::move(as_there));
  }
}

}  // namespace

const Rule kShapeLacksSymbol{
    {"SP414", "shape-lacks-symbol", diag::Severity::warning, "a device lacks a symbol that those named like it have",
     kShapeLacksSymbolPage, diag::Rank::siblings},
    check_shape_lacks_symbol};

}  // namespace symplant::check
