// What rules share.
#include "check/rule.hpp"

#include <algorithm>

namespace symplant::check {

diag::Place place_of(const model::PlantModel& plant, const read::ListRow& row, std::string_view cell) {
  const auto& source = plant.lists[plant.list_of(row)].table->source;
  return {source, cell.empty() ? row.whole : source->span_of(cell, row.whole)};
}

diag::Place place_of(const model::PlantModel& plant, const model::Symbol& symbol) {
  return place_of(plant, *symbol.row, symbol.name());
}

const model::Symbol& operation_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t place) {
  return plant.symbols[unit.operations[place]];
}

const model::Symbol& event_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t place) {
  return plant.symbols[unit.events[place]];
}

const model::Symbol& first_symbol_of(const model::PlantModel& plant, const model::Unit& unit) {
  std::uint32_t first = model::kNone;
  for (const auto* side : {&unit.operations, &unit.events}) {
    if (!side->empty()) first = std::min(first, side->front());
  }
  return plant.symbols[first];
}

std::string_view direction_text(core::Direction direction) {
  return direction == core::Direction::operation ? "operation" : "event";
}

}  // namespace symplant::check
