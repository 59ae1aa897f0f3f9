// Reads which nodes a model of the 3D view has.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/description.hpp"

namespace symplant::description {

/// The nodes of a model, or why it cannot be shown.
struct ModelReading {
  std::vector<std::string> paths;  ///< of the nodes with a name: the names from a root, with `/` between
  std::string error;               ///< empty: it is a model
};

/// Reads a binary glTF 2.0 file (.glb): at most 32 MiB, 20,000 nodes, 64 levels. O(bytes).
ModelReading read_model(std::string_view bytes);

/// Adds a fault for each node of `view3d` that the model does not have, or has several times; one only if the file is
/// no model. O(bytes + nodes of `view3d` * nodes of the model).
void check_model(std::string_view bytes, const GivenScene& scene, std::vector<DescriptionFault>& faults);

}  // namespace symplant::description
