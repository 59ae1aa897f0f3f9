// Turns plans into plants; draws again if a plan is rejected.
#include "property/random_plant.hpp"

#include <algorithm>
#include <utility>

#include "property/cell_plant.hpp"
#include "property/random_malfunctions.hpp"
#include "property/random_material.hpp"
#include "property/random_unit.hpp"
#include "property/random_values.hpp"

namespace symplant::property {
namespace {

std::size_t random_size(Dice& dice) {
  const std::size_t kind = dice.below(1000);
  if (kind < 460) return 1 + dice.below(3);
  if (kind < 760) return 4 + dice.below(3);
  if (kind < 920) return 7 + dice.below(6);
  return kind < 985 ? 13 + dice.below(18) : 55 + dice.below(10);
}

PlannedPlant random_plan(Dice& dice, const DrawOptions& options) {
  PlannedPlant plan;
  const std::size_t size = std::min(random_size(dice), options.most_units);
  for (std::size_t i = 0; i < size; ++i) {
    plan.units.push_back(random_unit(dice, i));
    plan.units.back().behaves = plan.units.back().behaves && options.behaviours;
  }
  static const std::vector<std::string> kBits = {"SPARE1", "SPARE-2", "L0_SPARE", "L0_P_S_X_1"};
  for (const std::string& name : kBits) {
    if (dice.percent(25)) plan.spare_bits.push_back(name);
  }
  for (const std::string name : {"LEVEL", "RECIPE-1"}) {
    if (dice.percent(20)) plan.spare_values.push_back(random_value(dice, name, dice.percent(50)));
  }
  plan.plain = dice.percent(40);
  if (plan.plain || !dice.percent(70)) return plan;
  for (const std::string name : {"LINE_READY", "FOLLOW-1", "FOLLOW-2"}) {
    if (dice.percent(50)) plan.followers.push_back(name);
  }
  if (dice.percent(40)) plan.followers.push_back(dice.pick(plan.units).path + "_I_READY");
  return plan;
}

/// More units than an instant has rounds at first, each driven by the one before it.
PlantText ripple_plant(Dice& dice) {
  PlantText text;
  const std::size_t size = 210 + dice.below(45);
  text.description.defaults.travel = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::string path = "L0_P_R" + std::to_string(i);
    const std::string number = std::to_string(i);
    text.rows.push_back({path + "_I_A", "%IX" + number, "BOOL", ""});
    if (i == 0) text.rows.push_back({path + "_O_A", "%QX0", "BOOL", ""});
    if (i == 0) text.rows.push_back({path + "_O_B", "%QX1", "BOOL", ""});
    description::DeviceDescription device;
    device.path = path;
    device.states = {i == 0 ? "C" : "B"};
    if (i > 0) {
      const std::string before = "L0_P_R" + std::to_string(i - 1) + ".B";
      device.transitions.push_back({"A", "B", "", before, true, false, {}, {}});
      device.transitions.push_back({"B", "A", "", "not " + before, true, false, {}, {}});
    }
    text.description.devices.push_back(std::move(device));
  }
  return text;
}

/// Separates addresses that two units drive.
model::Derived build_apart(PlantText& text) {
  model::Derived derived = build(text);
  for (int i = 0; i < 8 && !derived.evidence.driven_twice.empty(); ++i) {
    for (const auto& [second, first] : derived.evidence.driven_twice) {
      const std::string_view name = derived.plant.symbols[second].name();
      for (Row& row : text.rows) {
        if (row.name == name) row.address = row.address.substr(0, 3) + std::to_string(10'000 + second);
      }
    }
    derived = build(text);
  }
  return derived;
}

/// Parts for some plants. The dice are different ones, so that the rest of a plant is the same without material.
void add_material(PlantText& text, std::uint64_t draw) {
  Dice dice(draw * 2 + 0x3A7E'0000'0001);
  const std::size_t kind = dice.below(1000);
  if (kind >= 400 || text.rows.size() > 600) return;
  if (kind < 12) {
    text = {};
    add_reversing_tracks(dice, text);
  } else {
    add_random_material(dice, text, build(text).plant);
  }
}

/// Malfunctions for some plants, by other dice, too.
void add_malfunctions(PlantText& text, std::uint64_t draw) {
  Dice dice(draw * 2 + 0x3A7F'0000'0001);
  const bool ripples = text.rows.size() > 200;
  if (text.description.material.tracks.empty() && dice.one_in(60)) {
    text = {};
    return add_restless_malfunctions(dice, text);
  }
  if (dice.percent(ripples ? 10 : 40)) add_random_malfunctions(dice, text, build(text).plant);
}

/// Values and signals for some plants, by other dice, too.
void add_values(PlantText& text, std::uint64_t draw, bool malfunctions) {
  Dice dice(draw * 2 + 0x3A80'0000'0001);
  const bool ripples = text.rows.size() > 200;
  if (!dice.percent(ripples ? 5 : 40)) return;
  add_random_values(dice, text, build(text).plant);
  let_conditions_read_values(dice, text);
  let_drives_read_values(dice, text);
  let_times_read_values(dice, text);
  let_followers_switch(dice, text);
  if (malfunctions) add_malfunctions_of_values(dice, text);
}

std::string refusal(const model::Evidence& evidence) {
  if (!evidence.driven_twice.empty()) return "an address that two units move";
  if (evidence.faults.empty()) return "a behaviour that its unit does not serve";
  return evidence.faults.front().pointer + ": " + evidence.faults.front().message;
}

}  // namespace

DrawnPlant random_plant(std::uint64_t seed, const DrawOptions& options) {
  Dice dice(seed * 2 + 1);
  DrawnPlant drawn;
  for (;; ++drawn.refused) {
    drawn.text = {};
    if (options.naming_rules && seed % 8 == 7) {
      drawn.text = cell_plant(dice);
    } else if (options.most_units > 100 && dice.one_in(50)) {
      drawn.text = ripple_plant(dice);
    } else {
      const PlannedPlant plan = random_plan(dice, options);
      drawn.text.rows = random_rows(dice, plan);
      drawn.text.description = random_description(dice, plan, drawn.text.rows);
    }
    if (options.material) add_material(drawn.text, seed + 1'000'000'007 * static_cast<std::uint64_t>(drawn.refused));
    if (options.malfunctions) {
      add_malfunctions(drawn.text, seed + 1'000'000'007 * static_cast<std::uint64_t>(drawn.refused));
    }
    if (options.values) {
      add_values(drawn.text, seed + 1'000'000'007 * static_cast<std::uint64_t>(drawn.refused), options.malfunctions);
    }
    drawn.text.name = "drawn_" + std::to_string(seed);
    model::Derived derived = build_apart(drawn.text);
    const bool runs = runnable(derived);
    if (!runs && drawn.first_refusal.empty()) drawn.first_refusal = refusal(derived.evidence);
    drawn.model = std::move(derived.plant);
    if (runs) return drawn;
  }
}

}  // namespace symplant::property
