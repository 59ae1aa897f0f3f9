// SP404 event-not-driven: inputs of the PLC that no device drives.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "check/rules.hpp"
#include "model/part_words.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kEventNotDrivenPage =
    R"(A device has events and no operation: a push button, a light barrier, a healthy contact (emergency stop, air, doors).

**What the model loses.** No device drives these inputs: they keep their initial value until a scenario, a link or a person sets
them. A program that waits for healthy contacts never starts.

**How to fix it.** If such a contact is on in a healthy plant, give it the initial value TRUE in the list. If something in the
plant drives it, describe that in plant.json: automatic transitions with a `when`, or a behavior.
)";

/// Whether an event follows another one on its address that something drives.
bool follows_a_driven_one(const model::PlantModel& plant, std::uint32_t event) {
  const std::uint32_t leader = plant.symbols[event].leader;
  if (leader == model::kNone) return false;
  if (plant.symbols[leader].driven_without_unit()) return true;
  if (plant.symbols[leader].unit == model::kNone) return false;
  return plant.units[plant.symbols[leader].unit].moves();
}

/// The events of a unit without operations that nothing switches.
std::vector<std::uint32_t> left_alone(const model::PlantModel& plant, const model::Unit& unit) {
  std::vector<std::uint32_t> left;
  for (std::uint32_t location = 0; location < unit.events.size(); ++location) {
    if (unit.moves_event(location) || follows_a_driven_one(plant, unit.events[location])) continue;
    const bool sensor = !plant.material.empty() && model::looks_like_part_sensor(event_of(plant, unit, location));
    if (!sensor) left.push_back(unit.events[location]);  // SP630 reports those
  }
  return left;
}

/// Whether an event without a driver is on: that of the initial state, or no state's at all and Initial TRUE.
bool is_on(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t symbol) {
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const std::uint32_t event = unit.states[s].event;
    if (event != model::kNone && unit.events[event] == symbol) {
      return (s == unit.initial) != plant.symbols[symbol].inverted;
    }
  }
  return plant.symbols[symbol].initial != 0;
}

void check_event_not_driven(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (!unit.operations.empty()) continue;
    const std::vector<std::uint32_t> left = left_alone(plant, unit);
    if (left.empty()) continue;
    const model::Symbol& symbol = plant.symbols[left.front()];
    const std::string_view why =
        unit.moves() ? "since no state that the device reaches switches it" : "since the device has no operation";
    std::string message;
    if (left.size() > 1) {
      message = fmt::format("`{}` and {} more of `{}`: no device drives them, {}; they keep their initial values",
                            symbol.name(), left.size() - 1, unit.path, why);
    } else if (is_on(plant, unit, left.front())) {
      message = fmt::format("`{}`: no device drives it, {}; it stays on, as {} says", symbol.name(), why,
                            symbol.initial != 0 ? "Initial"
                            : symbol.inverted   ? "`inverted`"
                                                : "the description");
    } else {
      message = fmt::format(
          "`{}`: no device drives it, {}; it stays off; if it is a contact that is on in a healthy plant, "
          "write Initial TRUE",
          symbol.name(), why);
    }
    diagnostics.add(rule.info, about_sides(plant, unit, about(symbol).following(symbol_named(symbol.name()))),
                    std::move(message), location_of(plant, symbol));
  }
}

}  // namespace

const Rule kEventNotDriven{{"SP404", "event-not-driven", diag::Severity::note,
                            "inputs of the PLC that no device drives", kEventNotDrivenPage, diag::Rank::sides},
                           check_event_not_driven};

}  // namespace symplant::check
