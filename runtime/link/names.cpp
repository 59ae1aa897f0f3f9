// Finds symbols by name: an index over the blob of names.
#include "symplant/link/names.hpp"

#include <algorithm>

#include "symplant/tables/ascii.hpp"

namespace symplant::link {

namespace {

/// The text before the next NUL; removes both from `blob`.
std::string_view next_text(std::string_view& blob) {
  const std::string_view text = blob.substr(0, blob.find('\0'));
  blob.remove_prefix(std::min(text.size() + 1, blob.size()));
  return text;
}

}  // namespace

SymbolNames::SymbolNames(const tables::PlantTables& tables) {
  std::string_view blob = tables.symbol_names;
  rows_.reserve(tables.symbols.size());
  for (std::uint32_t row = 0; row < tables.symbols.size(); ++row) {
    rows_.emplace(tables::to_upper(next_text(blob)), row);
    next_text(blob);  // the address
  }
}

std::optional<std::uint32_t> SymbolNames::find(std::string_view name) const {
  const auto found = rows_.find(tables::to_upper(name));
  if (found == rows_.end()) return std::nullopt;
  return found->second;
}

}  // namespace symplant::link
