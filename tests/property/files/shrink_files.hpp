// Makes a case whose files show a difference as small as possible.
#pragma once

#include <functional>

#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// Removes steps and their actions, then what makes the files long, then parts of the plant, as long as `disagrees`
/// confirms that the case still shows the difference.
FileCase shrink(FileCase it, const std::function<bool(const FileCase&)>& disagrees);

}  // namespace symplant::property::files
