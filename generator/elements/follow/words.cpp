// Symbols that follow a condition in words.
#include "elements/follow/words.hpp"

#include "model/condition_text.hpp"

namespace symplant::view {

std::string follow_text(const model::Follow& follow, const model::PlantModel& plant) {
  std::string text = model::condition_text(follow.condition, plant);
  return follow.off ? text + "; off: " + model::condition_text(*follow.off, plant) : text;
}

}  // namespace symplant::view
