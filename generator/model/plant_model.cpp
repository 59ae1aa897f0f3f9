// Words for what the model holds.
#include "model/plant_model.hpp"

#include <algorithm>

namespace symplant::model {

std::string_view internal_reason_text(InternalReason reason) {
  switch (reason) {
    case InternalReason::constant:
      return "constants";
    case InternalReason::memory:
      return "memory addresses";
    case InternalReason::type:
      return "types that are no I/O";
    case InternalReason::no_direction:
      return "no address and no direction in the name";
  }
  return "";
}

bool Unit::reaches(std::uint32_t state) const {
  if (actuation == core::Actuation::spring && state == rest) return true;
  return std::any_of(transitions.begin(), transitions.end(), [&](const Transition& t) { return t.to == state; });
}

bool Unit::moves_event(std::uint32_t event) const {
  const auto found = std::find_if(states.begin(), states.end(), [&](const State& s) { return s.event == event; });
  if (found == states.end() || !moves()) return false;
  const auto state = static_cast<std::uint32_t>(found - states.begin());
  return state == initial || reaches(state);
}

std::string PlantModel::list_name() const {
  const std::string& path = list->source->path();
  return path.substr(path.find_last_of("/\\") + 1);
}

}  // namespace symplant::model
