// Shared by readers of delimited lists that are known by their header.
#include "read/formats/table_formats.hpp"

#include <algorithm>

namespace symplant::read {

std::optional<Layout> layout_in_any(std::string_view text, std::span<const HeaderWords> languages) {
  for (const HeaderWords& words : languages) {
    const auto end = std::find(words.begin(), words.end(), std::string_view());
    auto layout = below_header_with(text, {words.begin(), static_cast<std::size_t>(end - words.begin())});
    if (layout) return layout;
  }
  return std::nullopt;
}

}  // namespace symplant::read
