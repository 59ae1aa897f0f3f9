// Parts that a scenario puts and takes, and conditions that name parts.
#include "property/files/random_hands.hpp"

#include <algorithm>

#include "support/reference/patterns.hpp"
#include "support/reference/rules.hpp"

namespace symplant::property::files {
namespace {

std::uint32_t any_location(Dice& dice, const model::Material& material) {
  return static_cast<std::uint32_t>(dice.below(material.locations()));
}

std::string put_location(Dice& dice, const model::Material& material) {
  const std::uint32_t location = any_location(dice, material);
  std::string name = material.location_name(location);
  if (!material.is_track(location) || dice.percent(30)) return name;
  const std::int64_t length = material.tracks[location].length;
  const std::int64_t position = dice.percent(50)
                                    ? length * static_cast<std::int64_t>(dice.below(9)) / 8
                                    : static_cast<std::int64_t>(dice.below(static_cast<std::size_t>(length) + 1));
  return name + "@" + std::to_string(position) + "um";
}

/// The middle of a part, most of the time.
std::string take_location(Dice& dice, const model::Material& material, const reference::World& world) {
  std::vector<std::uint32_t> filled;
  for (std::uint32_t i = 0; i < material.locations(); ++i) {
    if (!world.material.at(i).empty()) filled.push_back(i);
  }
  if (filled.empty() || dice.percent(15)) return put_location(dice, material);
  const std::uint32_t location = dice.pick(filled);
  std::string name = material.location_name(location);
  if (!material.is_track(location) || dice.percent(20)) return name;
  const reference::PartWorld part = dice.pick(world.material.at(location));
  const std::int64_t middle = part.x(world.time) / reference::kMicrometer - material.kinds[part.kind].length / 2;
  return name + "@" + std::to_string(std::clamp<std::int64_t>(middle, 0, material.tracks[location].length)) + "um";
}

}  // namespace

void add_hands(Dice& dice, const model::Material& material, const reference::World& world, Step& step) {
  if (material.empty()) return;
  const auto several = [&] { return 1 + (dice.percent(30) ? 1 + dice.below(2) : 0); };
  const auto put = [&] { return std::pair(put_location(dice, material), dice.pick(material.kinds).name); };
  const bool puts = dice.percent(22);
  for (std::size_t i = puts ? several() : 0; i > 0; --i) step.put.push_back(put());
  for (std::size_t i = dice.percent(puts ? 30 : 12) ? several() : 0; i > 0; --i) {
    // What was put in the same step can be taken.
    step.take.push_back(puts && dice.percent(40) ? dice.pick(step.put).first : take_location(dice, material, world));
  }
}

std::vector<Step> steps_that_freeze_tracks(Dice& dice, const model::Material& material) {
  std::vector<Step> steps(2);
  for (Step& step : steps) step.time = 3 * tables::kMillisecond;
  steps.back().put.emplace_back(material.tracks[0].name, material.kinds[0].name);
  steps.back().expect_condition = condition_of_parts(dice, material);
  return steps;
}

std::string condition_of_parts(Dice& dice, const model::Material& material) {
  static const std::vector<std::string> kCompared = {"> 0", ">= 2", "= 1", "< 3", "= 0", "> 1.5", "<= 4"};
  const std::string name = material.location_name(any_location(dice, material)) + ".";
  const std::size_t kind = dice.below(100);
  if (kind < 40) return (dice.percent(30) ? "not " : "") + name + "part";
  if (kind < 65) {
    const std::string negated = dice.percent(30) ? "not " : "";
    return negated + name + dice.pick(material.kinds).name;
  }
  return name + "parts " + dice.pick(kCompared);
}

bool names_parts(const std::string& condition, const model::Material& material) {
  const std::string text = reference::upper(condition);
  for (std::uint32_t i = 0; i < material.locations(); ++i) {
    if (text.find(reference::upper(material.location_name(i)) + ".") != text.npos) return true;
  }
  return false;
}

}  // namespace symplant::property::files
