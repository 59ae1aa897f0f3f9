// Reads which nodes a model of the 3D view has.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "description/description.hpp"

namespace symplant::description {

/// A node that the model shows.
struct ModelNode {
  static constexpr std::uint32_t kNoParent = UINT32_MAX;

  std::string name;                  ///< empty: it has none
  std::uint32_t parent = kNoParent;  ///< the nearest ancestor with a name, as an index in the same list
};

/// The nodes of a model, or why it cannot be shown.
struct ModelReading {
  std::vector<ModelNode> nodes;
  std::string error;  ///< empty: it is a model
};

/// Reads a binary glTF 2.0 file (.glb): at most 32 MiB, 20,000 nodes, 64 levels, 1,000 bytes a name. O(bytes).
ModelReading read_model(std::string_view bytes);

/// The names of a node's ancestors and its own, with `/` between; nodes without a name are left out.
std::string path_of(const std::vector<ModelNode>& nodes, std::uint32_t node);

/// Adds a fault for each node of `view3d` that the model does not have, or has several times; one only if the file is
/// no model. O(bytes + nodes of `view3d` * nodes of the model).
void check_model(std::string_view bytes, const GivenScene& scene, std::vector<DescriptionFault>& faults);

}  // namespace symplant::description
