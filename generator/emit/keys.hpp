// The contract of the templates: every key, and what it holds. templates/README.md shows this table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::emit {

/// The template of the user's own files. It is filled for each item of the list `behaviours`.
inline constexpr std::string_view kOwnFile = "behavior.hpp";

struct Key {
  std::string_view key;
  std::string_view in;  ///< the lists within which it is known, separated by spaces; empty: everywhere
  bool list;
  std::string_view meaning;
};

std::span<const Key> keys();

/// Why a template may not use a key within these lists, as a text or as a list; empty if it may.
std::string fault_of_key(std::string_view key, const std::vector<std::string>& open_lists, bool as_list);

}  // namespace symplant::emit
