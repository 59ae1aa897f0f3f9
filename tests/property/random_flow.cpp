// Random transfers, work and sources, and conditions of devices that name parts.
#include <algorithm>

#include "property/random_material.hpp"
#include "property/random_unit.hpp"

namespace symplant::property {
namespace {

std::string name_of_spot(const std::string& spot) { return spot.substr(0, spot.find('@')); }

/// Replaces or extends a condition, with a chance.
void read_parts_in(MaterialPlan& plan, std::string& condition, unsigned chance) {
  if (!plan.dice.percent(chance)) return;
  const std::string atom =
      plan.dice.percent(70) || plan.bit_sensors.empty() ? plan.part_atom() : plan.dice.pick(plan.bit_sensors);
  if (condition.empty() || plan.dice.percent(60)) {
    condition = (plan.dice.percent(25) ? "not " : "") + atom;
  } else {
    condition = "(" + condition + ")" + (plan.dice.percent(50) ? " and " : " or ") + atom;
  }
}

std::optional<description::Duration> random_every(Dice& dice) {
  using tables::kMillisecond;
  static const std::vector<tables::Time> kGrid = {10 * kMillisecond, 20 * kMillisecond, 20 * kMillisecond,
                                                  50 * kMillisecond, 5'000'003};
  const std::size_t kind = dice.below(100);
  if (kind < 20) return std::nullopt;
  description::Duration duration = description::Duration::fixed(dice.pick(kGrid));
  if (kind < 60) return duration;
  duration.kind = kind < 80 ? description::Duration::Kind::uniform : description::Duration::Kind::normal;
  duration.b = kind < 80 ? duration.a + dice.pick(kGrid) : dice.pick(kGrid);
  if (dice.percent(15)) duration.a = 0;
  return duration;
}

}  // namespace

void draw_transfers(MaterialPlan& plan) {
  const std::size_t count = plan.dice.below(4);
  for (std::size_t i = 0; i < count; ++i) {
    description::GivenTransfer given;
    given.name = "t" + std::to_string(i + 1);
    given.from = plan.spot();
    given.to = plan.dice.percent(15) ? "out" : plan.spot();
    if (name_of_spot(given.from) == name_of_spot(given.to)) continue;
    if (plan.dice.percent(75)) given.when = plan.dice.percent(35) ? plan.switch_atom() : plan.condition();
    given.once = plan.dice.percent(45);
    // Back at once: a loop.
    description::GivenTransfer back = given;
    plan.material().transfers.push_back(std::move(given));
    if (plan.material().transfers.back().to == "out" || !plan.dice.percent(15)) continue;
    std::swap(back.from, back.to);
    back.name += "_back";
    back.once = false;
    if (plan.dice.percent(50)) back.when.clear();
    plan.material().transfers.push_back(std::move(back));
  }
}

void draw_work(MaterialPlan& plan) {
  const auto& kinds = plan.material().kinds;
  for (std::size_t i = 0; i < 3; ++i) {
    const description::GivenKind& from = plan.dice.pick(kinds);
    const description::GivenKind& to = plan.dice.pick(kinds);
    if (from.name == to.name || from.length != to.length) continue;
    const std::string at = plan.spot();
    std::string when = plan.condition();
    if (plan.dice.percent(25)) when = name_of_spot(at) + "." + from.name;
    plan.material().work.push_back({"w" + std::to_string(i + 1), "", at, std::move(when), from.name, to.name});
    if (!plan.dice.percent(30)) continue;
    const std::string back = name_of_spot(at) + "." + to.name;
    plan.material().work.push_back({"w" + std::to_string(i + 1) + "_back", "", at, back, to.name, from.name});
  }
}

void draw_sources(MaterialPlan& plan) {
  const std::size_t count = 1 + plan.dice.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    description::GivenSource given;
    given.name = "s" + std::to_string(i + 1);
    given.at = plan.dice.percent(70) ? plan.dice.pick(plan.tracks) : plan.spot();
    for (std::size_t k = 1 + plan.dice.below(3); k > 0; --k) {
      given.kinds.push_back(plan.dice.pick(plan.material().kinds).name);
    }
    given.every = random_every(plan.dice);
    if (plan.dice.percent(25)) given.first = random_time(plan.dice);
    if (plan.dice.percent(35)) given.count = 1 + plan.dice.below(plan.dice.percent(80) ? 6 : 60);
    if (plan.dice.percent(30)) given.when = plan.dice.percent(50) ? plan.switch_atom() : plan.condition();
    plan.material().sources.push_back(std::move(given));
  }
}

void read_parts(MaterialPlan& plan) {
  description::Description& description = plan.text.description;
  for (description::DeviceDescription& device : description.devices) {
    for (description::GivenTransition& given : device.transitions) {
      if (!given.when.empty()) read_parts_in(plan, given.when, 20);
      if (given.when.empty() && given.automatic) read_parts_in(plan, given.when, 10);
      if (!given.during.empty()) read_parts_in(plan, given.during, 20);
    }
    for (auto& [name, condition] : device.inputs) read_parts_in(plan, condition, 20);
  }
  for (description::GivenFollow& given : description.follow) read_parts_in(plan, given.condition, 25);
  for (description::GivenRequirement& given : description.requirements) {
    if (!given.never.empty()) read_parts_in(plan, given.never, 30);
    if (!given.after.empty()) read_parts_in(plan, given.after, 30);
    if (!given.expect.empty()) read_parts_in(plan, given.expect, 30);
  }
}

}  // namespace symplant::property
