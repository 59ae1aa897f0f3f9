// How the naming rule reads one symbol, for symplant explain.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/plant_model.hpp"

namespace symplant::app {

/// The texts as the rule sees them, each rule and where it ends, what was read, the device with its other symbols, and
/// the symbols of the other side whose names have the most words in common. Nothing if the lists have no I/O symbol of
/// that name. O(symbols).
std::optional<std::string> symbol_text(const model::PlantModel& plant, std::string_view name);

/// The name that is nearest to one that the lists do not have, for a message; empty if none is near. O(symbols).
std::string nearest_symbol(const model::PlantModel& plant, std::string_view name);

}  // namespace symplant::app
