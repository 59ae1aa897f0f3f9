// The combinations in which the atoms about one unit, bit or number can be true together.
#pragma once

#include <cstdint>
#include <vector>

#include "check/reachability/possible.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::check {

/// Each says which of a thing's atoms are true.
using Modes = std::vector<std::vector<bool>>;

/// A unit, a bit or a number that a condition tests, and all that it tests about it.
struct Thing {
  condition::Atom::Kind kind = condition::Atom::Kind::settled;  ///< of a unit always `settled`
  std::uint32_t location = 0;                                   ///< the unit, symbol or location of parts
  std::uint32_t part = 0;                                       ///< of parts: their kind, or kNone
  std::vector<condition::Atom> atoms;                           ///< each once
  Modes modes;

  static Thing of(const condition::Atom& atom);  ///< without the atom itself
  bool has(const condition::Atom& atom) const;   ///< the atom tests it
};

/// At least one. O(atoms, squared, and the unit's states).
Modes modes_of(const Thing& thing, const model::PlantModel& plant, const Possible& possible);

}  // namespace symplant::check
