// Rules: devices as a whole.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "check/spelling/device_classes.hpp"
#include "check/spelling/odd_devices.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

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

void check_one_task_alone(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const OddDevice& odd : odd_devices(subject)) {
    if (!odd.one_task) continue;
    const model::Unit& unit = plant.units[odd.device];
    const model::Symbol& symbol = first_symbol_of(plant, unit);
    const Lacking* other = nullptr;  // of a task that it lacks altogether
    for (const Lacking& lacking : odd.lacks) {
      const bool elsewhere = !text::equal_ignoring_case(lacking.others->reading.task(), symbol.reading.task());
      if (other == nullptr && elsewhere) other = &lacking;
    }
    if (other == nullptr) continue;
    diagnostics.add(rule.info, about(odd),
                    fmt::format("`{}` has the one task `{}`, where {} of {} devices named like it have `{}`, too: add "
                                "its rows",
                                unit.path, symbol.reading.task(), other->having, odd.of, other->others->reading.task()),
                    location_of(plant, symbol), {{location_of(plant, *other->others), "one that has it"}});
  }
}

/// The row next to the one that is missing: of the same task, or the device's first.
const model::Symbol& nearest_symbol(const Subject& subject, std::uint32_t device, std::string_view task) {
  const model::PlantModel& plant = subject.plant;
  if (device < plant.units.size()) {
    const model::Unit& unit = plant.units[device];
    for (const auto* side : {&unit.operations, &unit.events}) {
      for (const std::uint32_t s : *side) {
        if (text::equal_ignoring_case(plant.symbols[s].reading.task(), task)) return plant.symbols[s];
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
        location_of(plant, nearest_symbol(subject, odd.device, first.others->reading.task())), std::move(as_there));
  }
}

}  // namespace

const Rule kUnitTooLarge{
    {"SP406", "unit-too-large", diag::Severity::warning, "a device has more symbols or states than a device may have",
     R"(A device has more than 64 operations, 64 events or 250 states. Most often the level of the name that should distinguish devices
is the same for all of them.

**What the model loses.** All its symbols are in no unit: no device drives them. They are still served.

**How to fix it.** Check the device level of the names.
)",
     diag::Rank::row},
    check_unit_too_large};

const Rule kOneTaskAlone{
    {"SP413", "one-task-alone", diag::Severity::warning, "a device has one task, where those named like it have more",
     R"(A device has one task only (`O_OPEN`, `I_OPEN`), while nearly all devices named like it have more (`CLOSE`, too). Names are
alike if they differ in digits only: `CLAMP1`, `CLAMP2`.

**What the model loses.** A state. Instead the device gets a rest state without an event (inference 1): it returns there like a
spring, and nothing reports it. A program that waits for the other task waits forever.

**How to fix it.** Add the rows of the missing task. If the device really has one task, ignore the finding in plant.json, section
`check`.
)",
     diag::Rank::siblings},
    check_one_task_alone};

const Rule kShapeLacksSymbol{
    {"SP414", "shape-lacks-symbol", diag::Severity::warning, "a device lacks a symbol that those named like it have",
     R"(Nearly all devices named like this one have the same operations and events, and this one lacks some of them. Names are alike
if they differ in digits only (`CLAMP1`, `CLAMP2`), in any process. At least three others and three quarters of all must have
the symbol. If more than one device in eight lacks it, and more than one, the difference counts as intended.

**What the model loses.** What the symbol is for: without its operation a state is never commanded, without its event it is
never reported, without its number a scenario or a requirement has nothing to set or to read. The device gets another type than
the others, for example a single solenoid.

**How to fix it.** Add the row, or spell its task as the others do. If the device is really different, ignore the finding in
plant.json, section `check`.
)",
     diag::Rank::siblings},
    check_shape_lacks_symbol};

}  // namespace symplant::check
