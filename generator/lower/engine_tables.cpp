// The engine's view of tables made at run time.
#include "lower/engine_tables.hpp"

namespace symplant::lower {

void EngineTables::finish() {
  type_rows.clear();
  type_rows.reserve(types.size());
  for (const Type& type : types) {
    type_rows.push_back({type.operations, type.events, type.states, type.rest, type.actuation, type.transitions,
                         type.enter, type.leave, type.operation_targets});
  }
}

core::PlantTables EngineTables::tables() const {
  return {name,           type_rows,        units,          times,        symbols,
          initial_values, shared_addresses, operation_bits, event_bits,   operation_slots,
          event_slots,    unit_names,       state_names,    symbol_names, list};
}

}  // namespace symplant::lower
