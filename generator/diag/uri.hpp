// Converts paths of files to URIs.
#pragma once

#include <string>
#include <string_view>

namespace symplant::diag {

/// A file's URI, percent-encoded: relative to `folder` if the file is in it or its path is relative, else
/// `file:///...`. `folder` is absolute; an empty one contains no file. `path` may hold any bytes.
std::string file_uri(std::string_view path, std::string_view folder);

}  // namespace symplant::diag
