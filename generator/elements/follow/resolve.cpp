// Resolves the conditions that symbols follow.
#include "elements/follow/resolve.hpp"

#include <string>
#include <utility>
#include <vector>

#include "model/symbol_settings.hpp"

namespace symplant::model {

void resolve_follows(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults) {
  std::vector<Follow> follows;
  follows.reserve(plant.follows.size());
  for (Follow& follow : plant.follows) {
    const description::GivenFollow& given = plant.description->follow[follow.given];
    const description::Pointer here = follow_pointer(plant, follow.given);
    const bool is_pattern = given.symbol.find_first_of("*?") != std::string::npos;
    Symbol& symbol = plant.symbols[follow.symbol];
    std::string lacking;
    const bool sound = is_pattern ? conditions.resolve_made(given.condition, MatchedNames::of(symbol, given.symbol),
                                                            here.matched_by(given.symbol), follow.condition, &lacking)
                                  : conditions.resolve(given.condition, here, follow.condition);
    if (is_pattern) made.takes(here);
    if (!lacking.empty()) made.lacks(here, symbol.name(), std::move(lacking));
    if (sound) {
      follows.push_back(std::move(follow));
    } else {
      symbol.account = name::unpaired(symbol.direction);
    }
  }
  plant.follows = std::move(follows);
  check_follow_cycles(plant, faults);
}

}  // namespace symplant::model
