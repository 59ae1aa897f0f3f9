// The derived models for programs: complete, in the form that model.schema.json publishes.
#pragma once

#include <string_view>

#include "view/scene.hpp"

namespace symplant::view {

/// The version of the form; it changes where a reader of the old form would be misled.
inline constexpr int kModelJsonVersion = 1;

/// The units of the scene, every I/O symbol, every requirement. Times are in nanoseconds; names exactly as they are.
View model_json(const Scene& scene);

/// The JSON Schema (draft-07) of what model_json() writes.
std::string_view model_schema();

}  // namespace symplant::view
