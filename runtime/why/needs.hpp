// What must change for a condition to hold, or to hold no longer.
#pragma once

#include <string>
#include <vector>

#include "symplant/condition/tree.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/conditions.hpp"
#include "symplant/why/explanation.hpp"
#include "symplant/why/state_view.hpp"

namespace symplant::why {

bool holds(const condition::Atom& atom, const StateView& view);
bool holds(const Network& network, const StateView& view);

/// What must change for the opposite truth of a network: a tree of literals, none of which holds now. Each alternative
/// of an `any` is a minimal set of changes. A constant if no change is enough. A larger tree is cut to its first
/// kMostLiterals literals.
condition::Tree changes_of(const Network& network, const StateView& view);
inline constexpr std::size_t kMostLiterals = 200;

/// The unit, symbol, location or value that an atom reads; of a comparison of two the left one.
Reference reference_of(const condition::Atom& atom);

/// The different atoms of a tree, in their order.
std::vector<condition::Atom> atoms_of(const condition::Tree& tree);

/// A tree of literals: `L_P_AGV.P2 and not L_P_DOOR.OPEN1`, without what exceeds eight literals: `... and more`. A bit
/// of an inverted symbol is named by its meaning: `L_P_EYE_I_PART off (bit 1)`.
std::string condition_text(const condition::Tree& tree, const trace::PlantNames& names);

}  // namespace symplant::why
