// A case whose files show a disagreement, made as small as it goes.
#pragma once

#include <functional>

#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// Takes away steps and what they do, then what makes the files long, then parts of the plant, as long as `disagrees`
/// says that the case still shows what is wanted.
FileCase shrink(FileCase it, const std::function<bool(const FileCase&)>& disagrees);

}  // namespace symplant::property::files
