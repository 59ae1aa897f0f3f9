// Symbols by name: an index over the blob of names.
#include "symplant/link/names.hpp"

#include <algorithm>

namespace symplant::link {

namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string upper_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), upper);
  return result;
}

/// The text before the next NUL, which is taken off `blob` too.
std::string_view next_text(std::string_view& blob) {
  const std::string_view text = blob.substr(0, blob.find('\0'));
  blob.remove_prefix(std::min(text.size() + 1, blob.size()));
  return text;
}

}  // namespace

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return upper(x) == upper(y); });
}

SymbolNames::SymbolNames(const core::PlantTables& tables) {
  std::string_view blob = tables.symbol_names;
  rows_.reserve(tables.symbols.size());
  for (std::uint32_t row = 0; row < tables.symbols.size(); ++row) {
    rows_.emplace(upper_case(next_text(blob)), row);
    next_text(blob);  // the address
  }
}

std::optional<std::uint32_t> SymbolNames::find(std::string_view name) const {
  const auto found = rows_.find(upper_case(name));
  if (found == rows_.end()) return std::nullopt;
  return found->second;
}

}  // namespace symplant::link
