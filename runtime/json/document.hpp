// Parses JSON texts with locations of faults; comments are allowed, repeated keys are rejected.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "symplant/json/location.hpp"

namespace symplant::json {

/// Maximum nesting of arrays and objects.
inline constexpr std::size_t kMaxDepth = 100;

struct Document {
  /// Null if the text is not valid JSON. Members are in the order of their names.
  std::unique_ptr<nlohmann::json> root;
  std::vector<Placed> faults;

  Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;
  ~Document();
};

/// Parses UTF-8, with or without a byte order mark, with // and /* */ comments. Faults are: invalid JSON, a repeated
/// key in one object (the first counts), a NUL in a text (at most 100 faults for each of these two), and more than
/// kMaxDepth levels. Throws only std::bad_alloc. O(text).
Document parse(std::string_view text);

}  // namespace symplant::json
