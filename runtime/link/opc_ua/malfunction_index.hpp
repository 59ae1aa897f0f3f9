// Finds malfunctions by name, written and ordinary ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "symplant/link/names.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::opc_ua {

/// Without regard to the case of ASCII letters. Immutable. The tables must outlive it. O(plant) to make.
class MalfunctionIndex {
 public:
  explicit MalfunctionIndex(const tables::PlantTables& tables);

  /// As tables::MalfunctionNumbers numbers them; nothing if there is no such malfunction.
  std::optional<std::uint32_t> find(std::string_view name) const;

 private:
  const tables::PlantTables& tables_;
  std::unordered_map<std::string, std::uint32_t> written_;
  std::unordered_map<std::string, std::uint32_t> units_;
  SymbolNames symbols_;
};

}  // namespace symplant::link::opc_ua
