// SP630 part-sensor-not-described: an input that looks like a sensor of parts is not in `material`.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "model/part_words.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPartSensorNotDescribedPage =
    R"(The plant has a material flow, and inputs that look like photo-eyes, presence or pallet sensors by their names, but no sensor of
`material` drives them, and nothing else does.

**What the model loses.** These inputs never change. A program that waits for a part there waits forever.

**How to fix it.** Add them to `sensors` of a track or place, or let them follow a condition (`follow`). If they sense no parts, ignore
this finding in plant.json with a `why`.
)";

void check_part_sensor_not_described(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.material.empty()) return;
  constexpr std::size_t kMostNamed = 3;
  std::vector<const model::Symbol*> found;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.direction != tables::Direction::event) continue;
    if (model::is_driven(plant, symbol) || !model::looks_like_part_sensor(symbol)) continue;
    found.push_back(&symbol);
  }
  if (found.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < found.size() && i < kMostNamed; ++i) {
    names += fmt::format("{}`{}`", i == 0 ? "" : ", ", found[i]->name());
  }
  if (found.size() > kMostNamed) names += fmt::format(" and {} more", found.size() - kMostNamed);
  diag::Subjects subjects = about(*found.front());
  for (const model::Symbol* symbol : found) {
    if (symbol->unit != model::kNone)
      subjects = std::move(subjects).explaining(model_of(plant.units[symbol->unit].path));
  }
  diagnostics.add(
      rule.info, std::move(subjects),
      fmt::format("{} {} like {}, but no part drives {}: add {} to `sensors` of a track or place", names,
                  found.size() == 1 ? "looks" : "look", found.size() == 1 ? "a sensor of parts" : "sensors of parts",
                  found.size() == 1 ? "it" : "them", found.size() == 1 ? "it" : "them"),
      location_of(plant, *found.front()));
}

}  // namespace

const Rule kPartSensorNotDescribed{
    {"SP630", "part-sensor-not-described", diag::Severity::warning,
     "an input that looks like a sensor of parts is not in `material`", kPartSensorNotDescribedPage},
    check_part_sensor_not_described};

}  // namespace symplant::check
