// The tables of a plant as bytes, for a program that has no compiler.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::fmi {

/// The name of the file in the folder `resources` of an FMU.
inline constexpr std::string_view kTablesName = "plant.bin";

/// Little-endian and without padding: equal tables give equal bytes on every machine. Compiled formulas are left out.
/// O(tables).
std::string write_tables(const tables::PlantTables& tables);

/// Tables that were read from bytes, with their memory.
class LoadedTables {
 public:
  /// What write_tables() wrote. The error says why it is not, or of which version; a digest of the tables detects
  /// damage. O(bytes).
  static std::variant<std::unique_ptr<const LoadedTables>, std::string> read(std::string_view bytes);

  LoadedTables(const LoadedTables&) = delete;
  LoadedTables& operator=(const LoadedTables&) = delete;

  const tables::PlantTables& tables() const noexcept { return tables_; }

 private:
  LoadedTables() = default;

  std::vector<std::unique_ptr<std::byte[]>> memory_;  ///< of each table and text
  tables::PlantTables tables_{};
};

}  // namespace symplant::fmi
