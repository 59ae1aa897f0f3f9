// SP404 nobody-moves: inputs of the PLC that nobody moves.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPage =
    R"(A device has events and no operation: a push button, a light barrier, a healthy contact (emergency stop, air, doors).

**What the model loses.** Nothing in the plant moves these inputs: they stand as they start until a scenario, a link or a
person sets them. A program that waits for healthy contacts never starts on them.

**How to mend it.** Give such a contact the initial value TRUE in the list, if it is on in a healthy plant.
)";

/// Whether an event follows another on its address that a unit moves.
bool follows_a_moved_one(const model::PlantModel& plant, std::uint32_t event) {
  const std::uint32_t leader = plant.symbols[event].leader;
  if (leader == model::kNone || plant.symbols[leader].unit == model::kNone) return false;
  return plant.units[plant.symbols[leader].unit].moves();
}

void check_nobody_moves(const Rule& rule, const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  for (const model::Unit& unit : plant.units) {
    if (!unit.operations.empty() || follows_a_moved_one(plant, unit.events.front())) continue;
    const model::Symbol& symbol = first_symbol_of(plant, unit);
    if (unit.events.size() > 1) {
      diagnostics.add(
          rule.info,
          fmt::format("`{}` and {} more of `{}`: nobody moves them, since the device has no operation; they "
                      "stay as they start",
                      symbol.name(), unit.events.size() - 1, unit.path),
          place_of(plant, symbol));
      continue;
    }
    diagnostics.add(
        rule.info,
        symbol.initial != 0
            ? fmt::format("`{}`: nobody moves it, since the device has no operation; it stays on, as Initial "
                          "says",
                          symbol.name())
            : fmt::format("`{}`: nobody moves it, since the device has no operation; it stays off; if it is "
                          "a contact that is on in a healthy plant, write Initial TRUE",
                          symbol.name()),
        place_of(plant, symbol));
  }
}

}  // namespace

const Rule kNobodyMoves{{"SP404", "nobody-moves", diag::Severity::note, "inputs of the PLC that nobody moves", kPage},
                        check_nobody_moves};

}  // namespace symplant::check
