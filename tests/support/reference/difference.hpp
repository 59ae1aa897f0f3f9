// Where the model's derivation and the reference's differ.
#pragma once

#include <string>

#include "support/reference/rules.hpp"

namespace symplant::reference {

/// The first difference in words; empty where there is none.
std::string difference(const Rules& rules);

}  // namespace symplant::reference
