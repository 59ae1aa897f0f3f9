// The pictures and models of the panel over HTTP.
#pragma once

#include <optional>
#include <string_view>

#include "symplant/panel/scene/files.hpp"
#include "symplant/panel/web/routes.hpp"

namespace symplant::panel {

/// The answer to a GET of `files` or `files/NAME`; nothing for another path. O(the file), O(1) while it does not
/// change.
std::optional<Reply> scene_file(std::string_view path, SceneFiles& files);

}  // namespace symplant::panel
