// Rows of requirements.
#include "elements/requirement/rows.hpp"

#include "emit/row_text.hpp"

namespace symplant::emit {

std::string requirement_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t i = 0; i < tables.requirements.size(); ++i) {
    row_text(rows, tables.requirements[i]).comment(plant.requirements[i].name).text("\n");
  }
  return rows.take();
}

}  // namespace symplant::emit
