// Single steps toward a simpler plant.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "property/plant_text.hpp"

namespace symplant::property {

/// The size of the plant; every edit here reduces it.
std::size_t plant_size(const PlantText& plant);

/// LINE_PROC_DEV of rows that have these levels.
std::vector<std::string> unit_paths(const PlantText& plant);
/// Removes rows, description and everything that names the unit.
void remove_unit(PlantText& plant, const std::string& path);

/// False if the row shares no address.
bool give_own_address(PlantText& plant, std::size_t row);

/// Edits of single conditions, times, outputs and words, by number.
std::size_t count_simpler(const PlantText& plant);
void make_simpler(PlantText& plant, std::size_t number);

// Of the material flow (simpler_material.cpp).
std::size_t material_size(const description::GivenMaterial& material);
std::vector<std::string> part_locations(const PlantText& plant);
/// Removes a track or place with all that names it, except conditions of devices.
void remove_location(PlantText& plant, const std::string& name);
/// Calls `edit` with each condition, and whether it may be empty.
void each_condition(description::GivenMaterial& material, const std::function<void(std::string&, bool)>& visit);
/// Calls `visit` with each single edit.
void each_edit(description::GivenMaterial& material, const std::function<void(const std::function<void()>&)>& visit);

// Of malfunctions (simpler_malfunctions.cpp).
std::size_t malfunctions_size(const std::vector<description::GivenMalfunction>& malfunctions);
/// With what names it.
void remove_malfunction(PlantText& plant, const std::string& name);
/// Removes from malfunctions the devices and symbols for which `is_of` is true, a device with `_` at its end, and the
/// conditions for which `reads` is true.
void remove_from_malfunctions(PlantText& plant, const std::function<bool(const std::string&)>& is_of,
                              const std::function<bool(const std::string&)>& reads);
void each_condition(std::vector<description::GivenMalfunction>& malfunctions,
                    const std::function<void(std::string&, bool)>& visit);
void each_edit(std::vector<description::GivenMalfunction>& malfunctions,
               const std::function<void(const std::function<void()>&)>& visit);

// Of values and signals (simpler_values.cpp).
std::size_t values_size(const description::Description& description);
void each_condition(description::Description& description, const std::function<void(std::string&, bool)>& visit);
void each_edit(description::Description& description, const std::function<void(const std::function<void()>&)>& visit);

}  // namespace symplant::property
