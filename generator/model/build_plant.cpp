// From named symbols to the plant model.
#include "model/build_plant.hpp"

#include <unordered_map>

#include "base/index_table.hpp"
#include "base/large_memory.hpp"
#include "model/collect_symbols.hpp"
#include "model/derive_unit.hpp"
#include "model/describe.hpp"
#include "model/links.hpp"
#include "model/relations.hpp"
#include "model/shared_addresses.hpp"
#include "model/states.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

constexpr std::size_t kFew = 6;  ///< as many as the smallest piece of memory holds

/// Puts every BOOL symbol with a name by the rule into its device's unit.
void gather_units(PlantModel& plant) {
  base::IndexTable by_path(plant.symbols.size() / 4);
  base::reserve_large(plant.units, plant.symbols.size() / 4);
  std::uint32_t last = kNone;  // rows of one device mostly stand together
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    Symbol& symbol = plant.symbols[i];
    if (symbol.type != tables::DataType::boolean) {
      symbol.unmodelled = Unmodelled::numeric;
      continue;
    }
    if (symbol.reading.fault != name::NameFault::none) {
      symbol.unmodelled = Unmodelled::name;
      continue;
    }
    const std::string_view path = symbol.reading.device_path;
    if (last == kNone || plant.units[last].path != path) {
      const auto next = static_cast<std::uint32_t>(plant.units.size());
      last = by_path.find_or_add(text::hash_ignoring_case(path), next, [&](std::uint32_t unit) {
        return text::equal_ignoring_case(plant.units[unit].path, path);
      });
      if (last == next) {
        Unit& unit = plant.units.emplace_back();
        unit.path = path;
        unit.device = symbol.reading.device;
        unit.operations.reserve(kFew);
        unit.events.reserve(kFew);
      }
    }
    Unit& unit = plant.units[last];
    symbol.unit = last;
    (symbol.direction == tables::Direction::operation ? unit.operations : unit.events).push_back(i);
  }
}

/// Of several symbols with one task and direction the first stays.
void drop_taken_tasks(std::vector<std::uint32_t>& side, std::vector<Symbol>& symbols) {
  if (side.size() < 2) return;
  const auto taken = [&](std::size_t index) {
    for (std::size_t i = 0; i < index; ++i) {
      if (text::equal_ignoring_case(symbols[side[i]].reading.task, symbols[side[index]].reading.task)) return true;
    }
    return false;
  };
  const auto drop = [&](std::uint32_t symbol) {
    symbols[symbol].unmodelled = Unmodelled::task_taken;
    symbols[symbol].unit = kNone;
  };
  if (side.size() <= 16) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < side.size(); ++i) {
      side[kept] = side[i];
      if (taken(kept)) {
        drop(side[i]);
      } else {
        ++kept;
      }
    }
    side.resize(kept);
    return;
  }
  text::ByName<bool> tasks;
  std::erase_if(side, [&](std::uint32_t symbol) {
    if (tasks.try_emplace(symbols[symbol].reading.task, true).second) return false;
    drop(symbol);
    return true;
  });
}

/// False where the unit is larger than a unit may be; its symbols are unmodelled then.
bool within_limits(Unit& unit, PlantModel& plant, description::Faults& faults) {
  const std::size_t symbols = unit.operations.size() + unit.events.size();
  if (unit.operations.size() <= tables::kMaxOperations && unit.events.size() <= tables::kMaxEvents &&
      symbols <= tables::kMaxStates) {
    return true;  // without counting states: each has a symbol
  }
  const std::size_t states = states_of(unit, plant.symbols, TaskRoles(unit, plant.symbols)).size();
  if (unit.operations.size() <= tables::kMaxOperations && unit.events.size() <= tables::kMaxEvents &&
      states <= tables::kMaxStates) {
    return true;
  }
  TooLarge large{unit.path, unit.operations, unit.operations.size(), unit.events.size(), states};
  large.symbols.insert(large.symbols.end(), unit.events.begin(), unit.events.end());
  for (const std::uint32_t symbol : large.symbols) {
    plant.symbols[symbol].unmodelled = Unmodelled::unit_too_large;
    plant.symbols[symbol].unit = kNone;
  }
  plant.too_large.push_back(std::move(large));
  if (unit.described != nullptr && !unit.described->is_pattern()) {
    faults.add(
        description::device_pointer(*unit.described),
        description::ticked(unit.path) + " is described, but has too many symbols for a device and stays unmodelled");
  }
  return false;
}

void derive_units(PlantModel& plant, description::Faults& faults) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < plant.units.size(); ++i) {
    Unit& unit = plant.units[i];
    drop_taken_tasks(unit.operations, plant.symbols);
    drop_taken_tasks(unit.events, plant.symbols);
    if (!within_limits(unit, plant, faults)) continue;
    if (unit.described != nullptr) faults.describes(*unit.described);
    derive_unit(unit, plant.symbols, plant.description->defaults, faults);
    if (kept != i) {
      for (const auto* side : {&unit.operations, &unit.events}) {
        for (const std::uint32_t symbol : *side) plant.symbols[symbol].unit = static_cast<std::uint32_t>(kept);
      }
      plant.units[kept] = std::move(unit);
    }
    ++kept;
  }
  plant.units.resize(kept);
}

}  // namespace

PlantModel build_plant(const std::vector<ListInput>& lists, const BuildOptions& options) {
  PlantModel plant;
  plant.name = options.plant_name;
  plant.description =
      options.description != nullptr ? options.description : std::make_shared<const description::Description>();
  plant.rule = lists.front().named.rule;
  collect_symbols(plant, lists);
  gather_units(plant);
  description::Faults faults(plant.description_faults, plant.description_warnings);
  const std::vector<const description::LinkDescription*> links = check_links(plant, faults);
  describe_units(plant, faults);
  derive_units(plant, faults);
  add_relations(plant, faults);
  report_lacks(plant, faults);
  find_shared_addresses(plant);
  resolve_links(plant, links, faults);
  return plant;
}

}  // namespace symplant::model
