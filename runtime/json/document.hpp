// JSON texts as values, with the places of their faults: comments allowed, a key twice refused.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "symplant/json/location.hpp"

namespace symplant::json {

/// How deep arrays and objects may lie in each other.
inline constexpr std::size_t kMaxDepth = 100;

struct Document {
  /// Null where the text is no JSON. Members stand in the order of their names.
  std::unique_ptr<nlohmann::json> root;
  std::vector<Placed> faults;

  Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;
  ~Document();
};

/// Reads UTF-8, with a byte order mark or without, with // and /* */ comments. Faults are: a text that is no JSON, a
/// key twice in one object (the first counts), a NUL in a text, both told a hundred times at most, more than kMaxDepth
/// levels. Throws nothing but std::bad_alloc. O(text).
Document parse(std::string_view text);

}  // namespace symplant::json
