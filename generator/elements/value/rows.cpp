// Rows of values, signals and comparisons.
#include "elements/value/rows.hpp"

#include <string_view>
#include <vector>

#include "emit/row_text.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::emit {
namespace {

template <class Row>
std::string bare_rows(const std::vector<Row>& all) {
  RowWriter rows;
  for (const Row& row : all) bare_row(rows, row).text("\n");
  return rows.take();
}

/// Numbers, some in a line.
template <class Number>
std::string lines_of(const std::vector<Number>& numbers) {
  constexpr std::size_t kPerLine = 8;
  RowWriter rows;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    rows.text(i % kPerLine == 0 ? "    " : " ");
    FieldText{rows}(numbers[i]);
    rows.text(i % kPerLine == kPerLine - 1 || i + 1 == numbers.size() ? ",\n" : ",");
  }
  return rows.take();
}

}  // namespace

std::string value_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t v = 0; v < tables.values.rows.size(); ++v) {
    row_text(rows, tables.values.rows[v]).comment(plant.values[v].name);
    if (!plant.values[v].unit.empty()) rows.text(", ").comment(plant.values[v].unit);
    rows.text("\n");
  }
  return rows.take();
}

std::string value_order_rows(const lower::EngineTables& tables) { return lines_of(tables.values.order); }

std::string change_rows(const lower::EngineTables& tables) { return bare_rows(tables.values.changes); }

std::string signal_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::SignalRow& row : tables.values.signals) {
    row_text(rows, row).comment(plant.symbols[row.symbol].name()).text("\n");
  }
  return rows.take();
}

std::string formula_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  const std::vector<std::string_view> texts = tables::split_names(tables.values.formula_texts);
  for (std::size_t f = 0; f < tables.values.formulas.size(); ++f) {
    row_text(rows, tables.values.formulas[f]).comment(texts[f]).text("\n");
  }
  return rows.take();
}

std::string formula_step_rows(const lower::EngineTables& tables) { return bare_rows(tables.values.steps); }

std::string formula_input_rows(const lower::EngineTables& tables) { return bare_rows(tables.values.inputs); }

std::string number_rows(const lower::EngineTables& tables) { return lines_of(tables.values.numbers); }

std::string comparison_rows(const lower::EngineTables& tables) { return bare_rows(tables.values.comparisons); }

}  // namespace symplant::emit
