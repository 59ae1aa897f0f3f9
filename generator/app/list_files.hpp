// The files that an entry of `symbols` names: one, or all that a pattern matches.
#pragma once

#include <string>
#include <vector>

#include "base/file_system.hpp"

namespace symplant::app {

/// The file itself; for a path with `*` or `?`, all files that match, sorted by path. Each folder in the path may be a
/// pattern, too.
std::vector<std::string> list_files(const std::string& path, const base::FileSystem& files);

}  // namespace symplant::app
