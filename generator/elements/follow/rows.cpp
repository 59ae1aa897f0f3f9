// Rows of symbols that follow a condition.
#include "elements/follow/rows.hpp"

#include "emit/row_text.hpp"

namespace symplant::emit {

std::string follow_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::FollowRow& row : tables.follows) {
    row_text(rows, row).comment(plant.symbols[row.symbol].name()).text("\n");
  }
  return rows.take();
}

}  // namespace symplant::emit
