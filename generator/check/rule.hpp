// A rule: what is known of it, and how it looks for its fault.
#pragma once

#include <string_view>

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

struct Rule {
  diag::RuleInfo info;
  /// Adds a finding for every place where the rule is broken: one root cause, one finding.
  void (*check)(const Rule& rule, const model::PlantModel& plant, diag::Diagnostics& diagnostics) = nullptr;
};

/// Where a cell of a row stands: the cell itself, or the whole row where the cell is not in the file as it is.
diag::Place place_of(const model::PlantModel& plant, const read::ListRow& row, std::string_view cell);
/// A symbol's name.
diag::Place place_of(const model::PlantModel& plant, const model::Symbol& symbol);
/// The symbol at a place of a unit's operations or events.
const model::Symbol& operation_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t place);
const model::Symbol& event_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t place);
/// The first symbol of a unit in list order.
const model::Symbol& first_symbol_of(const model::PlantModel& plant, const model::Unit& unit);
/// "operation" or "event".
std::string_view direction_text(core::Direction direction);

}  // namespace symplant::check
