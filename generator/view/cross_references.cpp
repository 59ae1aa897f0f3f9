// Finds the states that disable a unit, and the requirements that name it.
#include "view/cross_references.hpp"

namespace symplant::view {
namespace {

using condition::Atom;
using condition::Tree;

class Notes {
 public:
  Notes(const model::PlantModel& plant, CrossReferences& references) : plant_(plant), references_(references) {}

  /// Adds `requirement` to every unit that a condition names, unless it is already the last entry there.
  void note(std::uint32_t requirement, const Tree& tree) {
    if (tree.kind == Tree::Kind::atom || (tree.kind == Tree::Kind::constant && tree.atom.kind == Atom::Kind::number)) {
      note(requirement, tree.atom);
    }
    for (const Tree& child : tree.children) note(requirement, child);
  }

 private:
  void note(std::uint32_t requirement, const Atom& atom) {
    switch (atom.kind) {
      case Atom::Kind::settled:
      case Atom::Kind::moving:
        return note_unit(requirement, atom.of);
      case Atom::Kind::bit:
      case Atom::Kind::number:
        return note_unit(requirement, plant_.symbols[atom.of].unit);
      case Atom::Kind::compare:
        for (const condition::Quantity& side : {atom.left, atom.right}) {
          if (side.kind == condition::Quantity::Kind::symbol) note_unit(requirement, plant_.symbols[side.of].unit);
        }
        return;
      case Atom::Kind::parts:  // they are in no unit
        return;
    }
  }

  void note_unit(std::uint32_t requirement, std::uint32_t unit) {
    if (unit == model::kNone) return;
    std::vector<std::uint32_t>& noted = references_.requirements[unit];
    if (noted.empty() || noted.back() != requirement) noted.push_back(requirement);
  }

  const model::PlantModel& plant_;
  CrossReferences& references_;
};

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
  Notes notes(plant, references);
  for (std::uint32_t i = 0; i < plant.requirements.size(); ++i) {
    notes.note(i, plant.requirements[i].condition);
    notes.note(i, plant.requirements[i].expected);
  }
  return references;
}

}  // namespace symplant::view
