// SP413 one-task-alone: a device has one task, where those named like it have more.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "check/spelling/odd_devices.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kOneTaskAlonePage =
    R"(A device has one task only (`O_OPEN`, `I_OPEN`), while nearly all devices named like it have more (`CLOSE`, too). Names are
alike if they differ in digits only: `CLAMP1`, `CLAMP2`.

**What the model loses.** A state. Instead the device gets a rest state without an event (inference 1): it returns there like a
spring, and nothing reports it. A program that waits for the other task waits forever.

**How to fix it.** Add the rows of the missing task. If the device really has one task, ignore the finding in plant.json, section
`check`.
)";

void check_one_task_alone(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const OddDevice& odd : odd_devices(subject)) {
    if (!odd.one_task) continue;
    const model::Unit& unit = plant.units[odd.device];
    const model::Symbol& symbol = first_symbol_of(plant, unit);
    const Lacking* other = nullptr;  // of a task that it lacks altogether
    for (const Lacking& lacking : odd.lacks) {
      const bool elsewhere = !text::equal_ignoring_case(lacking.others->reading.task, symbol.reading.task);
      if (other == nullptr && elsewhere) other = &lacking;
    }
    if (other == nullptr) continue;
    diagnostics.add(rule.info, about(odd),
                    fmt::format("`{}` has the one task `{}`, where {} of {} devices named like it have `{}`, too: add "
                                "its rows",
                                unit.path, symbol.reading.task, other->having, odd.of, other->others->reading.task),
                    location_of(plant, symbol), {{location_of(plant, *other->others), "one that has it"}});
  }
}

}  // namespace

const Rule kOneTaskAlone{
    {"SP413", "one-task-alone", diag::Severity::warning, "a device has one task, where those named like it have more",
     kOneTaskAlonePage, diag::Rank::siblings},
    check_one_task_alone};

}  // namespace symplant::check
