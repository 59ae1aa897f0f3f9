// Lowers the symbols that follow a condition.
#include "elements/follow/lower.hpp"

namespace symplant::lower {

void lower_follows(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables) {
  for (std::uint32_t f = 0; f < plant.follows.size(); ++f) {
    const model::Follow& follow = plant.follows[f];
    const std::uint32_t condition = add_condition(follow.condition, tables::ReaderKind::follow, f, 0);
    const std::uint32_t off = follow.off ? add_condition(*follow.off, tables::ReaderKind::follow, f, 1) : tables::kNone;
    tables.follows.push_back({follow.symbol, condition, off});
  }
}

}  // namespace symplant::lower
