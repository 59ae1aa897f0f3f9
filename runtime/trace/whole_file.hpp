// Replaces a file as a whole: it has the new contents, or still the old ones.
#pragma once

#include <string>
#include <string_view>

namespace symplant::trace {

/// A regular file is replaced only when all is written; a device or a pipe is written directly. Returns the reason of a
/// failure, or an empty text.
std::string write_whole_file(const std::string& path, std::string_view bytes);

}  // namespace symplant::trace
