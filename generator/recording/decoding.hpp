// The text of a file of another tool.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"

namespace symplant::recording {

struct DecodingError {
  std::string message;  ///< `FILE:4:7: ...`
};

/// UTF-8 of the bytes of a file; a character that is cut off at its end is `?`. The encoding is that of the byte order
/// mark, UTF-16, UTF-8, or else a likely code page, with a warning: times and values have no other characters than
/// ASCII. Binary files are errors. O(bytes).
base::Result<std::string, DecodingError> decoded(std::string bytes, const std::string& name,
                                                 std::vector<std::string>& warnings);

}  // namespace symplant::recording
