// The derived models as a table, for people at a terminal.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// The units of the scene, each with its eight elements, then the requirements, then the symbols in no device. The text
/// contains no character that is unsafe in a terminal, whatever characters the names contain.
View model_table(const Scene& scene);

}  // namespace symplant::view
