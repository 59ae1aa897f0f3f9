// Replaces names in braces within texts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace symplant::text {

/// Whether a text has an opening brace.
inline bool has_braces(std::string_view text) { return text.find('{') != std::string_view::npos; }

/// The replacement of a name in braces; nothing if it is unknown.
using BraceNames = std::function<std::optional<std::string_view>(std::string_view name)>;

struct Replaced {
  std::string text;
  std::string unknown;  ///< the first `{name}` that is unknown or has no closing brace, as it is written; else empty
};

/// The text with every `{name}` replaced. O(text).
Replaced replace_braces(std::string_view text, const BraceNames& names);

}  // namespace symplant::text
