// SP304 event-moved-twice: two devices move events on one address.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kEventMovedTwicePage =
    R"(Two events stand on one address, and different devices move them. The PLC reads one bit there; the plant would have two
answers for it.

**What the model loses.** It cannot be built.

**How to mend it.** Correct the address of one of them.
)";

void check_event_moved_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const auto& [second, first] : plant.moved_twice) {
    const model::Symbol& a = plant.symbols[first];
    const model::Symbol& b = plant.symbols[second];
    diagnostics.add(
        rule.info, about(b, a),
        fmt::format("`{}` stands on `{}` as `{}` does, and different devices move them: correct one address", b.name(),
                    b.address_cell, a.name()),
        place_of(plant, *b.row, b.address_cell), {{place_of(plant, *a.row, a.address_cell), "the other one"}});
  }
}

}  // namespace

const Rule kEventMovedTwice{{"SP304", "event-moved-twice", diag::Severity::error,
                             "two devices move events on one address", kEventMovedTwicePage},
                            check_event_moved_twice};

}  // namespace symplant::check
