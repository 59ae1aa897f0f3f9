// Accounts for symbols that nothing moves, by the words of panels, alarms, interlocks and data.
#pragma once

#include <span>
#include <vector>

#include "infer/evaluate.hpp"
#include "name/naming.hpp"

namespace symplant::infer {

/// Rules for what an operator sees and touches: a lamp and a button of one text are not a pair. O(samples * words).
std::vector<name::SymbolRule> panel_rules(const name::Naming& frame, std::span<const Sample> samples);

/// Rules for the words of interlocks that list one text on both sides: each side says it to its partner, and neither
/// causes the other. O(samples * words).
std::vector<name::SymbolRule> interlock_rules(const name::Naming& frame, std::span<const Sample> samples);

/// Rules for the words of alarms and resets that list one text on both sides: an overload has a contact and a lamp, a
/// reset a button and a lamp, and the lamp moves nothing. O(samples * words).
std::vector<name::SymbolRule> indicator_rules(const name::Naming& frame, std::span<const Sample> samples);

/// Adds rules for what nothing links. O(samples * words).
name::Naming with_roles(const name::Naming& naming, std::span<const Sample> samples);

}  // namespace symplant::infer
