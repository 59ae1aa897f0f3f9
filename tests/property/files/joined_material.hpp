// Entries of the material flow for each device that a pattern matches.
#pragma once

#include "property/dice.hpp"
#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// Adds places, transfers, work and sources, each list followed by those that one with `for` makes for other devices.
void add_joinable_material(Dice dice, PlantText& plant);

/// The plant's material, where some entries with `for` make one or several.
description::GivenMaterial joined_material(const PlantText& plant, const Style& style, Counts& counts);

}  // namespace symplant::property::files
