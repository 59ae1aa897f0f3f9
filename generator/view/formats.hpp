// The formats of model views.
#pragma once

#include <span>
#include <string_view>

#include "view/scene.hpp"

namespace symplant::view {

struct Format {
  std::string_view name;  ///< the value of --format
  std::string_view what;  ///< its purpose, for --help
  View (*render)(const Scene& scene);
};

/// All formats, in the order of --help.
std::span<const Format> formats();

/// The format of this name; null if there is no such format.
const Format* find_format(std::string_view name);

}  // namespace symplant::view
