// Compares two plants: symbols, devices, the rest of the model, the model hash.
#include "diff/compare.hpp"

#include <string_view>

#include "diff/causes.hpp"
#include "diff/devices.hpp"
#include "diff/symbols.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::diff {
namespace {

std::uint64_t hash_without_name(const lower::EngineTables& tables) {
  tables::PlantTables plant = tables.tables();
  plant.name = std::string_view();
  return tables::model_hash(plant);
}

}  // namespace

Difference compare(const Side& before, const Side& after) {
  Difference result;
  const SymbolPairs pairs = pair_symbols(before.plant, after.plant);
  result.rows = pairs.rows;
  result.symbols = symbol_changes(before.plant, after.plant, pairs);
  result.symbol_causes = symbol_causes(before.plant, after.plant, result.symbols);
  compare_models(before.plant, after.plant, pairs, result);
  result.device_causes = device_causes(before.plant, after.plant, result.devices);
  if (before.tables != nullptr) result.model_hash[0] = tables::model_hash(before.tables->tables());
  if (after.tables != nullptr) result.model_hash[1] = tables::model_hash(after.tables->tables());
  if (before.tables != nullptr && after.tables != nullptr) {
    result.same_model = hash_without_name(*before.tables) == hash_without_name(*after.tables);
  }
  return result;
}

}  // namespace symplant::diff
