// The contract of the templates: every key, and what it holds. templates/README.md shows this table.
#pragma once

#include <span>
#include <string_view>

namespace symplant::emit {

/// The template of the user's own files.
inline constexpr std::string_view kOwnFile = "behavior.hpp";

struct Key {
  std::string_view key;
  std::string_view where;  ///< the template that may use it; "*": all templates
  bool list;
  std::string_view meaning;
};

std::span<const Key> keys();

/// Whether a template may use a key.
bool is_key(std::string_view template_name, std::string_view key);

}  // namespace symplant::emit
