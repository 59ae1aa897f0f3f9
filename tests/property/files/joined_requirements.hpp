// Requirements for each device that a pattern matches.
#pragma once

#include <string>
#include <vector>

#include "property/dice.hpp"
#include "property/files/braces.hpp"
#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// Adds requirements of a device, each followed by those that one with `for` makes for other devices.
void add_joinable_requirements(Dice& dice, PlantText& plant, const std::string& path);

/// The plant's requirements, where some with `for` make several.
std::vector<description::GivenRequirement> joined_requirements(const PlantText& plant, const Style& style,
                                                               const KnownNames& known, Counts& counts);

}  // namespace symplant::property::files
