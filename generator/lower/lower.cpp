// Lowers the plant model to the engine's tables.
#include "lower/lower.hpp"

#include <map>
#include <string_view>
#include <utility>

#include "base/large_memory.hpp"
#include "lower/bit_plane.hpp"
#include "lower/lower_conditions.hpp"
#include "lower/lower_symbols.hpp"
#include "lower/marks.hpp"
#include "lower/time_table.hpp"
#include "lower/type_table.hpp"

namespace symplant::lower {
namespace {

using model::kNone;

class Lowering {
 public:
  explicit Lowering(const model::PlantModel& plant) : plant_(plant) {}

  EngineTables run() {
    tables_.name = plant_.name;
    lower_units();
    lower_times(plant_, tables_);
    lower_symbols(plant_, symbol_bits_, operations_, events_, tables_);
    lower_lists();
    lower_state_names();
    lower_disables();
    lower_conditions(plant_, tables_);
    lower_behaviours();
    mark_what_costs_more(tables_);
    tables_.operation_bits = operations_.size();
    tables_.event_bits = events_.size();
    tables_.finish();
    return std::move(tables_);
  }

 private:
  void lower_units() {
    TypeTable types;
    symbol_bits_.assign(plant_.symbols.size(), kNone);
    base::reserve_large(tables_.units, plant_.units.size());
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      const model::Unit& unit = plant_.units[u];
      tables::UnitRow row{};
      const std::uint32_t type = types.type_of(plant_, u, tables_.types);
      row.type = type & 0x7F'FFFF;
      row.initial = unit.initial & 0xFF;
      row.operation_bit = operations_.take_for(u, unit.operations.size());
      row.event_bit = events_.take(unit.events.size());
      for (std::uint32_t i = 0; i < unit.operations.size(); ++i) {
        symbol_bits_[unit.operations[i]] = row.operation_bit + i;
      }
      for (std::uint32_t i = 0; i < unit.events.size(); ++i) symbol_bits_[unit.events[i]] = row.event_bit + i;
      tables_.units.push_back(row);
      tables_.unit_names.append(unit.path).push_back('\0');
      if (unit.overrun != tables::kNever) tables_.overruns.push_back({u, unit.overrun});
    }
  }

  void lower_lists() {
    std::uint32_t first = 0;
    for (std::uint32_t list = 0; list < plant_.lists.size(); ++list) {
      while (first < plant_.symbols.size() && plant_.symbols[first].list < list) ++first;
      tables_.lists.push_back({first, plant_.lists[list].controller});
      tables_.list_names.append(plant_.lists[list].name()).push_back('\0');
    }
    for (const std::string& name : plant_.controllers) tables_.controller_names.append(name).push_back('\0');
  }

  void lower_state_names() {
    for (const Type& type : tables_.types) {
      for (const model::State& state : plant_.units[type.example].states) {
        tables_.state_names.append(state.name).push_back('\0');
      }
    }
  }

  /// The model has them in table order: by unit, then by state, ascending.
  void lower_disables() {
    for (std::uint32_t by = 0; by < plant_.units.size(); ++by) {
      const auto& states = plant_.units[by].disables;
      for (std::size_t state = 0; state < states.size(); ++state) {
        for (const std::uint32_t unit : states[state]) {
          tables_.disables.push_back({by, unit, static_cast<std::uint8_t>(state)});
        }
      }
    }
  }

  /// Behaviors of one name are one class, for all its units.
  void lower_behaviours() {
    std::map<std::string_view, std::uint32_t> names;
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      const model::Unit& unit = plant_.units[u];
      if (!unit.has_behaviour()) continue;
      const std::string_view name = unit.described->behaviour;
      const auto [found, added] = names.try_emplace(name, static_cast<std::uint32_t>(names.size()));
      if (added) tables_.behaviour_names.append(name).push_back('\0');
      tables_.behaviour_units.push_back({u, found->second, unit.first_input,
                                         static_cast<std::uint32_t>(unit.conditions.size()) - unit.first_input,
                                         static_cast<std::uint32_t>(tables_.behaviour_values.size()),
                                         static_cast<std::uint32_t>(unit.values.size())});
      tables_.behaviour_values.insert(tables_.behaviour_values.end(), unit.values.begin(), unit.values.end());
    }
  }

  const model::PlantModel& plant_;
  EngineTables tables_;
  OperationPlane operations_;
  BitPlane events_;
  std::vector<std::uint32_t> symbol_bits_;
};

}  // namespace

EngineTables lower(const model::PlantModel& plant) { return Lowering(plant).run(); }

}  // namespace symplant::lower
