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

std::string devices(const model::Effect& effect, const model::PlantModel& plant) {
  std::string text;
  const auto add = [&](std::string_view name) { text.append(text.empty() ? "" : ", ").append(name); };
  for (const tables::MalfunctionUnit& each : effect.units) add(plant.units[each.unit].path);
  for (const std::uint32_t track : effect.tracks) add(plant.material.tracks[track].name);
  return text.empty() ? "no device" : text;
}

/// `TRUE`, `5`; what the bit of an inverted symbol means: `on (bit 0)`.
std::string forced_value(const model::Symbol& symbol, std::uint64_t value) {
  return symbol.inverted ? std::string(tables::level_text(value == 0, true)) : value_text(symbol.type, value);
}

std::string forces(const model::Effect& effect, const model::PlantModel& plant) {
  std::string text;
  for (const tables::MalfunctionForce& force : effect.forces) {
    const model::Symbol& symbol = plant.symbols[force.symbol];
    const std::string value = force.holds ? "as it is" : forced_value(symbol, force.value);
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", symbol.name(), value);
  }
  return text;
}

std::string sets(const model::Effect& effect, const model::PlantModel& plant) {
  std::string text;
  for (const tables::MalfunctionSet& set : effect.sets) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", plant.values[set.value].name, set.number);
  }
  return text;
}

/// "distort SYMBOL: gain 1.02, offset 5, drift 0.1 a second", without what changes nothing.
std::string distort(const model::Effect& effect, const model::PlantModel& plant) {
  const description::GivenDistort& given = effect.distort;
  std::string text;
  const auto add = [&](std::string_view part) { text.append(text.empty() ? "" : ", ").append(part); };
  if (given.gain != 1) add(fmt::format("gain {}", given.gain));
  if (given.offset != 0) add(fmt::format("offset {}", given.offset));
  if (given.drift != 0) add(fmt::format("drift {} a second", given.drift));
  const std::uint32_t symbol = plant.signals[effect.subject].row.symbol;
  return fmt::format("distort {}: {}", plant.symbols[symbol].name(), text);
}

std::string effect_text(const model::Effect& effect, const model::PlantModel& plant) {
  switch (effect.kind) {
    case tables::MalfunctionKind::slower:
      return fmt::format("slower {}: {}", effect.factor / 1000.0, devices(effect, plant));
    case tables::MalfunctionKind::stuck: {
      const auto& units = effect.units;
      const bool in_a_state = !units.empty() && units.front().state != tables::kNoState;
      const std::string state =
          in_a_state ? " in " + plant.units[units.front().unit].states[units.front().state].name : std::string();
      return fmt::format("stuck{}: {}", state, devices(effect, plant));
    }
    case tables::MalfunctionKind::force:
      return "force " + forces(effect, plant);
    case tables::MalfunctionKind::flicker:
      return fmt::format("flicker {} for {} every {}", plant.symbols[effect.subject].name(),
                         duration_text(Duration::fixed(effect.shows)), duration_text(*effect.every));
    case tables::MalfunctionKind::lose: {
      const std::string& controller = plant.controllers[effect.subject];
      return controller.empty() ? "lose the controller" : "lose " + controller;
    }
    case tables::MalfunctionKind::set:
      return "set " + sets(effect, plant);
    case tables::MalfunctionKind::distort:
      return distort(effect, plant);
  }
  return {};
}

}  // namespace

std::string malfunction_text(const model::Malfunction& malfunction, const model::PlantModel& plant) {
  std::string text;
  for (const model::Effect& effect : malfunction.effects) {
    text += (text.empty() ? "" : " and ") + effect_text(effect, plant);
  }
  if (malfunction.condition)
    text += (malfunction.during ? "; while " : "; when ") + model::condition_text(*malfunction.condition, plant);
  if (malfunction.chance) text += "; by chance, " + duration_text(*malfunction.chance);
  if (malfunction.lasts) text += "; lasts " + duration_text(*malfunction.lasts);
  if (malfunction.next == kNone) return text;
  text += fmt::format("; becomes `{}` after {}", plant.malfunctions[malfunction.next].name,
                      duration_text(Duration::fixed(malfunction.after)));
  return malfunction.unless ? text + " unless " + model::condition_text(*malfunction.unless, plant) : text;
}

}  // namespace symplant::view
