// SP407 task-claimed-twice: two symbols of a device claim one task and direction.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTaskClaimedTwicePage =
    R"(Two symbols of one device have the same task and the same direction. Names are unique, so the direction of one of them comes
from an address that contradicts its name. The address counts, since it is wired.

**What the model loses.** The first row keeps the task. The other symbol is in no unit: it is still served, but it drives no
device, and no device drives it.

**How to fix it.** Correct the name or the address of one of them.
)";

void check_task_claimed_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const TaskClaim& claim : task_claims(plant)) {
    const model::Symbol& symbol = plant.symbols[claim.overruled];
    const model::Symbol& other = plant.symbols[claim.other];
    const std::string_view direction = direction_text(symbol.direction);
    diagnostics.add(
        rule.info,
        about(symbol)
            .explaining(device(symbol.reading.device_path))
            .explaining(address_of(symbol.name()))
            .following(address_of(symbol.name())),
        claim.other_dropped
            ? fmt::format("`{}` is an {} by its address `{}`, and takes the task from `{}`, which is in no device now: "
                          "correct its name or its address",
                          symbol.name(), direction, symbol.address_cell, other.name())
            : fmt::format("`{}` is an {} by its address `{}`, and `{}` has that task already, so that it is in no "
                          "device: correct its name or its address",
                          symbol.name(), direction, symbol.address_cell, other.name()),
        location_of(plant, *symbol.row, symbol.address_cell),
        {{location_of(plant, other), "the symbol that has the task by its name"}});
  }
}

}  // namespace

const Rule kTaskClaimedTwice{
    {"SP407", "task-claimed-twice", diag::Severity::warning, "two symbols of a device claim one task and direction",
     kTaskClaimedTwicePage, diag::Rank::direction},
    check_task_claimed_twice};

}  // namespace symplant::check
