// SP304 event-driven-twice: two devices, conditions or sensors of parts drive events on one address.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kEventDrivenTwicePage =
    R"(Two events have one address, and different devices drive them, or a condition (`follow`) or a sensor of parts drives at least
one. The PLC reads one bit there, and the plant would have two values for it.

**What the model loses.** The plant cannot be built.

**How to fix it.** Correct the address of one of them.
)";

void check_event_driven_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const auto& [second, first] : subject.evidence.driven_twice) {
    const model::Symbol& a = plant.symbols[first];
    const model::Symbol& b = plant.symbols[second];
    const bool devices = !a.driven_without_unit() && !b.driven_without_unit();
    diagnostics.add(
        rule.info, about(b, a).following(address_of(b.name())).following(address_of(a.name())),
        fmt::format("`{}` has the address `{}`, as `{}` has, and {}: correct one address", b.name(), b.address_cell,
                    a.name(), devices ? "different devices drive them" : "the plant drives each of them separately"),
        location_of(plant, *b.row, b.address_cell), {{location_of(plant, *a.row, a.address_cell), "the other one"}});
  }
}

}  // namespace

const Rule kEventDrivenTwice{{"SP304", "event-driven-twice", diag::Severity::error,
                              "two devices drive events on one address", kEventDrivenTwicePage},
                             check_event_driven_twice};

}  // namespace symplant::check
