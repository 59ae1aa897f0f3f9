// Why a text is not a pattern.
#pragma once

#include <cstddef>
#include <string>

namespace symplant::name {

struct PatternFault {
  std::size_t offset = 0;  ///< in the pattern, in bytes
  std::string message;
};

}  // namespace symplant::name
