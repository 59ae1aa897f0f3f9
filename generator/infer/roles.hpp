// Accounts for symbols that nothing moves, by the words of panels, alarms, interlocks and data.
#pragma once

#include <span>

#include "infer/evaluate.hpp"
#include "name/naming.hpp"

namespace symplant::infer {

/// Adds rules with roles before those that link. A word counts only if no paired symbol has it. O(samples * words).
name::Naming with_roles(const name::Naming& naming, std::span<const Sample> samples);

}  // namespace symplant::infer
