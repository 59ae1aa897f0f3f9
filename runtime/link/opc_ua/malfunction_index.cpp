// Finds malfunctions by name, written and ordinary ones.
#include "symplant/link/opc_ua/malfunction_index.hpp"

#include "symplant/tables/ascii.hpp"
#include "symplant/tables/malfunction_names.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::opc_ua {

namespace {

std::unordered_map<std::string, std::uint32_t> index_of(std::string_view blob) {
  std::unordered_map<std::string, std::uint32_t> index;
  std::uint32_t row = 0;
  for (const std::string_view name : tables::split_names(blob)) index.emplace(tables::to_upper(name), row++);
  return index;
}

std::optional<std::uint32_t> found_in(const std::unordered_map<std::string, std::uint32_t>& index,
                                      const std::string& name) {
  const auto found = index.find(name);
  return found == index.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

MalfunctionIndex::MalfunctionIndex(const tables::PlantTables& tables)
    : tables_(tables),
      written_(index_of(tables.malfunctions.names)),
      units_(index_of(tables.unit_names)),
      symbols_(tables) {}

std::optional<std::uint32_t> MalfunctionIndex::find(std::string_view name) const {
  const std::string wanted = tables::to_upper(name);
  if (const auto written = found_in(written_, wanted)) return written;
  return tables::ordinary_malfunction(
      tables::MalfunctionNumbers(tables_), wanted, [this](std::string_view symbol) { return symbols_.find(symbol); },
      [this](std::string_view unit) { return found_in(units_, std::string(unit)); });
}

}  // namespace symplant::link::opc_ua
