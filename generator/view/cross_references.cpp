// Finds the states that disable a unit, and the requirements that name it.
#include "view/cross_references.hpp"

namespace symplant::view {
namespace {

using condition::Atom;
using condition::Tree;

/// Adds `requirement` to every unit that a condition names, unless it is already the last entry there.
void note(std::uint32_t requirement, const Tree& tree, const model::PlantModel& plant, CrossReferences& references) {
  const bool of_parts = tree.atom.kind == Atom::Kind::parts;  // they are in no unit
  if ((tree.kind == Tree::Kind::atom && !of_parts) ||
      (tree.kind == Tree::Kind::constant && tree.atom.kind == Atom::Kind::number)) {
    const bool of_unit = tree.atom.kind == Atom::Kind::settled || tree.atom.kind == Atom::Kind::moving;
    const std::uint32_t unit = of_unit ? tree.atom.of : plant.symbols[tree.atom.of].unit;
    if (unit == model::kNone) return;
    std::vector<std::uint32_t>& noted = references.requirements[unit];
    if (noted.empty() || noted.back() != requirement) noted.push_back(requirement);
  }
  for (const Tree& child : tree.children) note(requirement, child, plant, references);
}

}  // namespace

CrossReferences cross_references(const model::PlantModel& plant) {
  CrossReferences references;
  references.disabled_by.resize(plant.units.size());
  references.requirements.resize(plant.units.size());
  for (std::uint32_t by = 0; by < plant.units.size(); ++by) {
    const auto& disables = plant.units[by].disables;
    for (std::uint32_t state = 0; state < disables.size(); ++state) {
      for (const std::uint32_t unit : disables[state]) references.disabled_by[unit].push_back({by, state});
    }
  }
  for (std::uint32_t i = 0; i < plant.requirements.size(); ++i) {
    note(i, plant.requirements[i].condition, plant, references);
    note(i, plant.requirements[i].expected, plant, references);
  }
  return references;
}

}  // namespace symplant::view
