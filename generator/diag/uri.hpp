// Names of files as URIs.
#pragma once

#include <string>
#include <string_view>

namespace symplant::diag {

/// A file's URI, percent-encoded: relative to `folder` where the file lies in it or is named relatively, else
/// `file:///...`. `folder` is absolute; where it is empty nothing lies in it. Any bytes do for `path`.
std::string file_uri(std::string_view path, std::string_view folder);

}  // namespace symplant::diag
