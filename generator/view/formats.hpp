// The formats in which a model can be seen.
#pragma once

#include <span>
#include <string_view>

#include "view/scene.hpp"

namespace symplant::view {

struct Format {
  std::string_view name;  ///< as --format has it
  std::string_view what;  ///< what it is for, in a few words
  View (*render)(const Scene& scene);
};

/// All of them, in the order in which help tells them.
std::span<const Format> formats();

/// Null where no format is called so.
const Format* find_format(std::string_view name);

}  // namespace symplant::view
