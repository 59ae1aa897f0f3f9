// The derived models for people, in a terminal.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// The units of the scene, each with its eight elements; then the requirements, and what is in no device. No character
/// that a terminal must not get is in it, whatever the names hold.
View model_table(const Scene& scene);

}  // namespace symplant::view
