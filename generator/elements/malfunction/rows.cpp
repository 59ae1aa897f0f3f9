// Rows of the malfunctions.
#include "elements/malfunction/rows.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "emit/row_text.hpp"
#include "symplant/tables/names.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
std::string malfunction_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  const std::vector<std::string_view> names = tables::split_names(tables.malfunctions.names);
  for (std::size_t m = 0; m < tables.malfunctions.rows.size(); ++m) {
    row_text(rows, tables.malfunctions.rows[m]).comment(names[m]).text("\n");
  }
  return rows.take();
}

std::string effect_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  const std::vector<std::string_view> names = tables::split_names(tables.malfunctions.names);
  const tables::MalfunctionTables all = tables.malfunctions.tables();
  for (std::uint32_t m = 0; m < all.size(); ++m) {
    for (const tables::EffectRow& row : all.effects_of(m)) row_text(rows, row).comment(names[m]).text("\n");
  }
  return rows.take();
}

std::string malfunction_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::MalfunctionUnit& row : tables.malfunctions.units) {
    const bool any = row.state == tables::kNoState;
    row_text(rows, row).comment(plant.units[row.unit].path);
    if (!any) rows.text(".").comment(plant.units[row.unit].states[row.state].name);
    rows.text("\n");
  }
  return rows.take();
}

std::string malfunction_track_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const std::uint32_t track : tables.malfunctions.tracks) {
    rows.text("    ").number(track).text(",  // ").comment(plant.material.tracks[track].name).text("\n");
  }
  return rows.take();
}

std::string malfunction_force_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::MalfunctionForce& row : tables.malfunctions.forces) {
    row_text(rows, row).comment(plant.symbols[row.symbol].name()).text("\n");
  }
  return rows.take();
}

std::string malfunction_set_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::MalfunctionSet& row : tables.malfunctions.sets) {
    row_text(rows, row).comment(plant.values[row.value].name).text("\n");
  }
  return rows.take();
}

/// Blanks are written as `_`: `eye blind` becomes `eye_blind`.
std::string malfunction_constant_rows(const model::PlantModel& plant) {
  RowWriter rows;
  text::IdentifierScope scope;
  for (std::size_t m = 0; m < plant.malfunctions.size(); ++m) {
    std::string name = plant.malfunctions[m].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    rows.text("  ").text(scope.unique(name)).text(" = ").number(m).text(",\n");
  }
  return rows.take();
}

}  // namespace symplant::emit
