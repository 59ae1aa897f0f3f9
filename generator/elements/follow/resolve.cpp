// Resolves the conditions that symbols follow.
#include "elements/follow/resolve.hpp"

#include <string>
#include <utility>
#include <vector>

#include "model/symbol_settings.hpp"
#include "text/pattern.hpp"

namespace symplant::model {

void resolve_follows(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults) {
  std::vector<Follow> follows;
  follows.reserve(plant.follows.size());
  for (Follow& follow : plant.follows) {
    const description::GivenFollow& given = plant.description->follow[follow.given];
    const description::Pointer here = follow_pointer(plant, follow.given);
    const bool is_pattern = text::is_pattern(given.symbol);
    Symbol& symbol = plant.symbols[follow.symbol];
    std::string lacking;
    const auto resolve = [&](const std::string& text, const description::Pointer& at, condition::Tree& tree) {
      return is_pattern ? conditions.resolve_made(text, MatchedNames::of(symbol, given.symbol),
                                                  at.matched_by(given.symbol), tree, &lacking)
                        : conditions.resolve(text, at, tree);
    };
    const bool switches = !given.off.empty();
    bool sound = resolve(given.condition, switches ? here / "on" : here, follow.condition);
    if (switches) sound = resolve(given.off, here / "off", follow.off.emplace()) && sound;
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
