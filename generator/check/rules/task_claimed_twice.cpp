// SP407 task-claimed-twice: two symbols of a device claim one task and direction.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPage =
    R"(Two symbols of one device have the same task and the same direction. Since names are unique, the direction of one of them
comes from an address that overruled its name.

**What the model loses.** The first keeps the task; the other is in no unit.

**How to mend it.** Correct the name or the address of one of them.
)";

void check_task_claimed_twice(const Rule& rule, const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.unmodelled != model::Unmodelled::task_taken) continue;
    diagnostics.add(
        rule.info,
        fmt::format("`{}` is a second {} with task {} of {}: it is in no device; correct its name or its address",
                    symbol.name(), direction_text(symbol.direction), symbol.reading.task, symbol.reading.device_path),
        place_of(plant, symbol));
  }
}

}  // namespace

const Rule kTaskClaimedTwice{{"SP407", "task-claimed-twice", diag::Severity::warning,
                              "two symbols of a device claim one task and direction", kPage},
                             check_task_claimed_twice};

}  // namespace symplant::check
