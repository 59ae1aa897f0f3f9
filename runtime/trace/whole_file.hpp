// Writes a file that is complete, or as it was before.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace symplant::trace {

/// Writes the parts one after the other. A file of this path is replaced only when all is written; a device or a pipe
/// is written as it is. Returns the reason of a failure, or an empty text.
std::string write_whole_file(const std::string& path, std::initializer_list<std::string_view> parts);

}  // namespace symplant::trace
