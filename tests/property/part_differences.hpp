// The difference between the parts of engine and reference, as text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "support/reference/reference.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::property {

/// The changes of parts of an instant, only their defined members.
std::vector<std::string> part_texts(const reference::InstantRecord& record, const model::PlantModel& plant);
/// The first difference; empty if there is none.
std::string parts_difference(const plant::Plant& engine, const reference::Plant& reference,
                             const model::PlantModel& plant);

/// The difference between a reference and one with further instants, which change nothing.
std::string disturbance(const reference::Plant& undisturbed, const reference::Plant& disturbed,
                        const model::PlantModel& plant);

/// TRACK, TRACK@um or PLACE; empty if the plant has no such location.
std::optional<tables::PartLocation> part_location(const model::Material& material, const std::string& text);

}  // namespace symplant::property
