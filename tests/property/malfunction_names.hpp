// How actions name malfunctions: written ones by their names, ordinary ones by words without blanks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/plant_model.hpp"

namespace symplant::property {

/// The number of NAME, `stuck:UNIT`, `slow:UNIT`, `on:SYMBOL` or `off:SYMBOL`; empty if the plant has no such
/// malfunction.
std::optional<std::uint32_t> malfunction_number(const model::PlantModel& model, const std::string& text);
std::string malfunction_text(const model::PlantModel& model, std::uint32_t number);

}  // namespace symplant::property
