// Writes a file that is complete, or as it was before.
#pragma once

#include <string>
#include <string_view>

namespace symplant::trace {

/// A file of this path is replaced only when all is written; a device or a pipe is written as it is. Returns the reason
/// of a failure, or an empty text.
std::string write_whole_file(const std::string& path, std::string_view bytes);

}  // namespace symplant::trace
