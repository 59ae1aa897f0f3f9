// Malfunctions that a scenario starts and stops.
#include "property/files/random_starts.hpp"

#include "property/malfunction_names.hpp"
#include "property/random_malfunctions.hpp"
#include "support/reference/lines.hpp"

namespace symplant::property::files {
namespace {

/// Of a device or symbol. Empty if there is none such.
std::string any_malfunction(Dice& dice, const model::PlantModel& plant) {
  const auto number = malfunction_number(plant, random_malfunction(dice, plant));
  if (!number) return {};
  const std::size_t first = plant.malfunctions.size() + 2 * plant.units.size();
  if (*number >= first) {
    const model::Symbol& symbol = plant.symbols[(*number - first) / 2];
    const bool is_event = symbol.direction == tables::Direction::event;
    if (!is_event || symbol.type != tables::DataType::boolean) return {};
  }
  return reference::malfunction_name(plant, *number);
}

void add_any(Dice& dice, const model::PlantModel& plant, std::vector<std::string>& names) {
  std::string name = any_malfunction(dice, plant);
  if (!name.empty()) names.push_back(std::move(name));
}

}  // namespace

void add_starts(Dice& dice, const model::PlantModel& plant, const reference::World& world, bool too_many, Step& step) {
  const auto& active = world.malfunctions.active;
  if (dice.percent(active.empty() ? 2 : 12)) {
    for (std::size_t i = 1 + dice.below(2); i > 0; --i) {
      if (active.empty() || dice.percent(15)) {
        add_any(dice, plant, step.stop);
      } else {
        step.stop.push_back(reference::malfunction_name(plant, dice.pick(active).number));
      }
    }
  }
  const unsigned starts = plant.malfunctions.empty() ? 8 : 22;
  if (dice.percent(starts)) {
    for (std::size_t i = 1 + (dice.percent(30) ? dice.below(3) : 0); i > 0; --i) add_any(dice, plant, step.start);
    // It begins again.
    if (!step.stop.empty() && dice.percent(40)) step.start.push_back(step.stop.front());
  }
  if (!too_many || plant.units.size() < 33 || !dice.percent(25)) return;
  for (std::uint32_t i = 0; i < 66; ++i) {
    step.start.push_back(reference::malfunction_name(plant, static_cast<std::uint32_t>(plant.malfunctions.size()) + i));
  }
}

std::vector<Step> steps_that_freeze_malfunctions(Dice& dice) {
  std::vector<Step> steps(3);
  for (Step& step : steps) step.time = 1 + static_cast<tables::Time>(dice.below(4)) * tables::kMillisecond;
  steps[1].start.emplace_back("restless1");
  steps[2].start.emplace_back("restless1");
  for (Step& step : steps) step.expect_condition = dice.percent(50) ? "EYE" : "not L0_P_D0_I_B";
  return steps;
}

}  // namespace symplant::property::files
