// Active malfunctions in explanations.
#pragma once

#include "symplant/trace/influences.hpp"
#include "symplant/why/explanation.hpp"

namespace symplant::why {

/// Adds a cause for each active malfunction that the explanation does not name.
void add_malfunctions(Explanation& explanation, const trace::PlantNames& names, trace::ActiveMalfunctions active);

}  // namespace symplant::why
