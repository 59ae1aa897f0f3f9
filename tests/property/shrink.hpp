// A case that shows a disagreement, made as small as it goes.
#pragma once

#include <functional>

#include "property/plant_text.hpp"

namespace symplant::property {

/// Takes away actions, then units, then what is said of them, as long as `disagrees` says that the case still shows
/// what is wanted; at most `most_runs` questions are asked.
Case shrink(Case the_case, const std::function<bool(const Case&)>& disagrees, int most_runs = 4000);

}  // namespace symplant::property
