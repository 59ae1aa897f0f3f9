// Which units a change concerns.
#include "observe/dependents.hpp"

namespace symplant::observe {
namespace {

void add_dependents(const condition::Tree& tree, std::uint32_t unit, Dependents& dependents) {
  if (tree.kind == condition::Tree::Kind::atom) {
    const condition::Atom& atom = tree.atom;
    using Kind = condition::Atom::Kind;
    if (atom.kind == Kind::settled || atom.kind == Kind::moving) dependents.of_unit[atom.of].push_back(unit);
    if (atom.kind == Kind::bit || atom.kind == Kind::number) dependents.of_symbol[atom.of].push_back(unit);
    if (atom.kind == Kind::compare) {
      for (const condition::Quantity& side : {atom.left, atom.right}) {
        if (side.kind == condition::Quantity::Kind::symbol) dependents.of_symbol[side.of].push_back(unit);
      }
    }
  }
  for (const condition::Tree& child : tree.children) add_dependents(child, unit, dependents);
}

}  // namespace

Dependents dependents_of(const model::PlantModel& plant) {
  Dependents dependents;
  dependents.of_symbol.resize(plant.symbols.size());
  dependents.of_unit.resize(plant.units.size());
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const model::Unit& unit = plant.units[u];
    for (std::size_t c = 0; c < unit.first_input && c < unit.conditions.size(); ++c) {
      add_dependents(unit.conditions[c], u, dependents);
    }
    for (const std::vector<std::uint32_t>& disabled : unit.disables) {
      for (const std::uint32_t other : disabled) dependents.of_unit[u].push_back(other);
    }
  }
  dependents.read_by.resize(plant.units.size());
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    for (const std::uint32_t other : dependents.of_unit[u]) {
      if (other != u) dependents.read_by[other].push_back(u);
    }
  }
  return dependents;
}

}  // namespace symplant::observe
