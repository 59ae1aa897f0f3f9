// Gives the engine a view of tables that were made at run time.
#include "lower/engine_tables.hpp"

namespace symplant::lower {

void EngineTables::finish() {
  type_rows.clear();
  type_rows.reserve(types.size());
  for (const Type& type : types) {
    type_rows.push_back({type.operations, type.events, type.states, type.rest, type.actuation, type.transitions,
                         type.enter, type.leave, type.operation_targets, type.times, type.travel});
  }
}

EngineTables EngineTables::copy() const {
  EngineTables result(*this);
  result.finish();
  return result;
}

tables::MaterialTables Material::tables() const {
  return {
      .kinds = kinds,
      .tracks = tracks,
      .drives = drives,
      .stops = stops,
      .ends = ends,
      .sensors = sensors,
      .places = places,
      .transfers = transfers,
      .work = work,
      .sources = sources,
      .sensor_kinds = sensor_kinds,
      .source_kinds = source_kinds,
      .counters = counters,
      .kind_names = kind_names,
      .location_names = location_names,
      .transfer_names = transfer_names,
      .work_names = work_names,
      .source_names = source_names,
  };
}

tables::MalfunctionTables Malfunctions::tables() const { return {rows, effects, units, tracks, forces, sets, names}; }

tables::ValueTables Values::tables() const {
  return {rows,   order,   changes,     signals, formulas, steps,        {},
          inputs, numbers, comparisons, outputs, names,    formula_texts};
}

tables::PlantTables EngineTables::tables() const {
  return {
      .name = name,
      .types = type_rows,
      .units = units,
      .times = times,
      .random_times = random_times,
      .symbols = symbols,
      .lists = lists,
      .initial_values = initial_values,
      .shared_addresses = shared_addresses,
      .disables = disables,
      .conditions = conditions,
      .conditioned_units = conditioned_units,
      .unit_watches = unit_watches,
      .operation_watches = operation_watches,
      .event_watches = event_watches,
      .operation_value_watches = operation_value_watches,
      .event_value_watches = event_value_watches,
      .requirements = requirements,
      .follows = follows,
      .overruns = overruns,
      .material = material.tables(),
      .part_watches = part_watches,
      .malfunctions = malfunctions.tables(),
      .values = values.tables(),
      .behaviour_units = behaviour_units,
      .behaviour_values = behaviour_values,
      .operation_bits = operation_bits,
      .event_bits = event_bits,
      .operation_slots = operation_slots,
      .event_slots = event_slots,
      .unit_names = unit_names,
      .state_names = state_names,
      .symbol_names = symbol_names,
      .requirement_names = requirement_names,
      .behaviour_names = behaviour_names,
      .list_names = list_names,
      .controller_names = controller_names,
  };
}

}  // namespace symplant::lower
