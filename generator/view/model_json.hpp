// The derived models as JSON, for programs: complete, in the format that model.schema.json defines.
#pragma once

#include <string_view>

#include "view/scene.hpp"

namespace symplant::view {

/// The version of the format. It changes if a reader of the old format would misinterpret the new one.
inline constexpr int kModelJsonVersion = 1;

/// The units of the scene, every I/O symbol, every requirement. Times are in nanoseconds, names are unchanged.
View model_json(const Scene& scene);

/// The JSON Schema (draft-07) of the output of model_json().
std::string_view model_schema();

}  // namespace symplant::view
