// Compares the devices of two plants.
#include "diff/devices.hpp"

#include <utility>

#include "diff/items.hpp"
#include "diff/translated.hpp"

namespace symplant::diff {
namespace {

/// States that have another name, as changes.
std::vector<ItemChange> state_renames(const model::Unit& before, const model::Unit& after,
                                      const std::vector<std::uint32_t>& symbols) {
  std::vector<ItemChange> changes;
  const std::vector<std::uint32_t> states = renamed_states(before, after, symbols);
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (states[s] != kNone) changes.push_back({"state name", "", before.states[states[s]].name, after.states[s].name});
  }
  return changes;
}

}  // namespace

void compare_models(const model::PlantModel& before, const model::PlantModel& after, const SymbolPairs& pairs,
                    Difference& result) {
  const std::vector<std::uint32_t> symbols = symbols_after(before, after, pairs);
  const std::vector<std::uint32_t> units = units_after(before, after, symbols);
  const model::PlantModel old = translated(before, after, symbols, units);
  std::vector<std::uint32_t> old_of(after.units.size(), kNone);
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    if (units[u] != kNone) old_of[units[u]] = u;
  }
  for (std::uint32_t u = 0; u < old_of.size(); ++u) {
    if (old_of[u] == kNone) {
      result.devices.push_back({kNone, u, false, {}});
      continue;
    }
    const model::Unit& was = before.units[old_of[u]];
    DeviceChange change{old_of[u], u, was.path != after.units[u].path, state_renames(was, after.units[u], symbols)};
    for (ItemChange& item : item_changes(items_of(old, old.units[old_of[u]]), items_of(after, after.units[u]))) {
      change.items.push_back(std::move(item));
    }
    if (change.renamed || !change.items.empty()) result.devices.push_back(std::move(change));
  }
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    if (units[u] == kNone) result.devices.push_back({u, kNone, false, {}});
  }
  std::vector<Item> old_items = plant_items(old);
  std::vector<Item> new_items = plant_items(after);
  if (before.description_source == nullptr || after.description_source == nullptr) {
    const auto is_name = [](const Item& item) { return item.element == "plant"; };  // a bare list has that of its file
    std::erase_if(old_items, is_name);
    std::erase_if(new_items, is_name);
  }
  result.plant = item_changes(old_items, new_items);
}

}  // namespace symplant::diff
