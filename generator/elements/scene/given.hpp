// The plan and the 3D view of the panel as the description gives them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace symplant::description {

/// A name in `plan` or `view3d`, for which the plant must have something.
struct SceneName {
  enum class Kind : std::uint8_t {
    device,
    location,  ///< a track or a place
    frame,     ///< a station, or a group that `groups` has
    posed,     ///< a device, one of whose states is `state`
    number,    ///< a value, or a numeric symbol
  };
  Kind kind;
  std::string name;
  std::string state;    ///< of `posed`
  std::string pointer;  ///< JSON pointer to it in the description
};

/// A node of the model that something in `view3d` is bound to.
struct SceneNode {
  std::string path;
  std::string pointer;  ///< JSON pointer to it in the description
};

struct GivenScene {
  std::string plan;    ///< the object as JSON; empty: not given
  std::string view3d;  ///< the same
  std::vector<SceneName> names;
  std::vector<std::string> groups;  ///< that devices of `plan` name
  std::string model;                ///< a file name; empty: no model
  std::vector<SceneNode> nodes;
};

}  // namespace symplant::description
