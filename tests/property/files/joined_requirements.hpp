// Requirements for each device that a pattern matches.
#pragma once

#include <string>
#include <vector>

#include "property/dice.hpp"
#include "property/files/braces.hpp"
#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// Adds requirements of a device, each with those of other devices that one with `for` stands for.
void add_joinable_requirements(Dice& dice, PlantText& plant, const std::string& path);

/// The plant's requirements, where some with `for` stand for several.
std::vector<description::GivenRequirement> joined_requirements(const PlantText& plant, const Style& style,
                                                               const KnownNames& known, Counts& counts);

}  // namespace symplant::property::files
