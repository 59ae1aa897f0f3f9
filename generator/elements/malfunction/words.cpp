// Malfunctions in words.
#include "elements/malfunction/words.hpp"

#include <fmt/format.h>

#include "model/condition_text.hpp"
#include "symplant/tables/level.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using description::Duration;
using model::kNone;

std::string devices(const model::Malfunction& malfunction, const model::PlantModel& plant) {
  std::string text;
  for (const tables::MalfunctionUnit& each : malfunction.units) {
    text.append(text.empty() ? "" : ", ").append(plant.units[each.unit].path);
  }
  return text.empty() ? "no device" : text;
}

/// `TRUE`, `5`; what the bit of an inverted symbol means: `on (bit 0)`.
std::string forced_value(const model::Symbol& symbol, std::uint64_t value) {
  return symbol.inverted ? std::string(tables::level_text(value == 0, true)) : value_text(symbol.type, value);
}

std::string forces(const model::Malfunction& malfunction, const model::PlantModel& plant) {
  std::string text;
  for (const tables::MalfunctionForce& force : malfunction.forces) {
    const model::Symbol& symbol = plant.symbols[force.symbol];
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", symbol.name(), forced_value(symbol, force.value));
  }
  return text;
}

std::string effect(const model::Malfunction& malfunction, const model::PlantModel& plant) {
  switch (malfunction.kind) {
    case tables::MalfunctionKind::slower:
      return fmt::format("slower {}: {}", malfunction.factor / 1000.0, devices(malfunction, plant));
    case tables::MalfunctionKind::stuck: {
      const auto& units = malfunction.units;
      const bool in_a_state = !units.empty() && units.front().state != tables::kNoState;
      const std::string state =
          in_a_state ? " in " + plant.units[units.front().unit].states[units.front().state].name : std::string();
      return fmt::format("stuck{}: {}", state, devices(malfunction, plant));
    }
    case tables::MalfunctionKind::force:
      return "force " + forces(malfunction, plant);
    case tables::MalfunctionKind::flicker:
      return fmt::format("flicker {} for {} every {}", plant.symbols[malfunction.subject].name(),
                         duration_text(Duration::fixed(malfunction.shows)), duration_text(*malfunction.every));
    case tables::MalfunctionKind::lose: {
      const std::string& controller = plant.controllers[malfunction.subject];
      return controller.empty() ? "lose the controller" : "lose " + controller;
    }
  }
  return {};
}

}  // namespace

std::string malfunction_text(const model::Malfunction& malfunction, const model::PlantModel& plant) {
  std::string text = effect(malfunction, plant);
  if (malfunction.condition) text += "; when " + model::condition_text(*malfunction.condition, plant);
  if (malfunction.chance) text += "; by chance, " + duration_text(*malfunction.chance);
  if (malfunction.lasts) text += "; lasts " + duration_text(*malfunction.lasts);
  if (malfunction.next == kNone) return text;
  text += fmt::format("; becomes `{}` after {}", plant.malfunctions[malfunction.next].name,
                      duration_text(Duration::fixed(malfunction.after)));
  return malfunction.unless ? text + " unless " + model::condition_text(*malfunction.unless, plant) : text;
}

}  // namespace symplant::view
