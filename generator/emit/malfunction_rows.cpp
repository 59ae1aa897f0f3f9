// Rows of the malfunctions.
#include "emit/malfunction_rows.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "emit/row_writer.hpp"
#include "symplant/tables/names.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
namespace {

constexpr std::array<std::string_view, 5> kMalfunctionKinds{"slower", "stuck", "force", "flicker", "lose"};

RowWriter& index_or_none(RowWriter& rows, std::uint32_t value) {
  return value == tables::kNone ? rows.text("tables::kNone") : rows.number(value);
}

}  // namespace

std::string malfunction_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  const std::vector<std::string_view> names = tables::split_names(tables.malfunctions.names);
  for (std::size_t m = 0; m < tables.malfunctions.rows.size(); ++m) {
    const tables::MalfunctionRow& row = tables.malfunctions.rows[m];
    rows.text("    {tables::MalfunctionKind::").text(kMalfunctionKinds[static_cast<std::size_t>(row.kind)]);
    rows.text(", {").numbers(row.of.first, row.of.count).text("}, ").number(row.factor).text(", ");
    index_or_none(rows, row.subject).text(", ").numbers(row.every, row.shows).text(", ");
    index_or_none(rows, row.condition).text(", ").numbers(row.chance, row.lasts, row.after).text(", ");
    index_or_none(rows, row.next).text(", ");
    index_or_none(rows, row.unless).text("},  // ").comment(names[m]).text("\n");
  }
  return rows.take();
}

std::string malfunction_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::MalfunctionUnit& row : tables.malfunctions.units) {
    const bool any = row.state == tables::kNoState;
    rows.text("    {").number(row.unit).text(", ");
    (any ? rows.text("tables::kNoState") : rows.number(unsigned{row.state})).text("},  // ");
    rows.comment(plant.units[row.unit].path);
    if (!any) rows.text(".").comment(plant.units[row.unit].states[row.state].name);
    rows.text("\n");
  }
  return rows.take();
}

std::string malfunction_force_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::MalfunctionForce& row : tables.malfunctions.forces) {
    rows.text("    {").number(row.symbol).text(", ").hex(row.value).text("},  // ");
    rows.comment(plant.symbols[row.symbol].name()).text("\n");
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
