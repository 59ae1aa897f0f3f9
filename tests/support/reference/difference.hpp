// Where the derivations of the model and of the reference differ.
#pragma once

#include <string>

#include "support/reference/rules.hpp"

namespace symplant::reference {

/// The first difference as text; empty if both are equal.
std::string difference(const Rules& rules);

}  // namespace symplant::reference
