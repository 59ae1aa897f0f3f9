// Splits the name blobs of the tables.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// The texts of a blob, each ended by a NUL, as views into it. O(blob).
inline std::vector<std::string_view> split_names(std::string_view blob) {
  std::vector<std::string_view> names;
  for (std::size_t at = 0; at < blob.size();) {
    const std::size_t end = blob.find('\0', at);
    names.push_back(blob.substr(at, end - at));
    at = end == blob.npos ? blob.size() : end + 1;
  }
  return names;
}

}  // namespace symplant::tables
