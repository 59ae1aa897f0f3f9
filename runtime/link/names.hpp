// Finds symbols by name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "symplant/tables/tables.hpp"

namespace symplant::link {

/// Finds symbols by name, without regard to the case of ASCII letters. Immutable.
class SymbolNames {
 public:
  explicit SymbolNames(const tables::PlantTables& tables);

  /// The symbol's row in PlantTables::symbols; nothing if there is no such symbol.
  std::optional<std::uint32_t> find(std::string_view name) const;

 private:
  std::unordered_map<std::string, std::uint32_t> rows_;
};

}  // namespace symplant::link
