// Makes the entries of the material flow: one for each device that the `for` of an entry matches.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "description/faults.hpp"
#include "elements/material/given.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// The origin of a made entry.
struct MadeBy {
  std::uint32_t given = 0;  ///< its index in the description
  std::string key;          ///< in the description: the name with braces, if the list is an object
  std::string pattern;      ///< `for`; empty without it
  std::string device;       ///< the device that `for` matched
  std::string lacking;      ///< what the entry names and the plant lacks, so that it is left out; empty: nothing
};

/// Entries in which `for` and names in braces are resolved, and for each list the origins of its entries.
struct MadeMaterial {
  description::GivenMaterial entries;
  std::vector<MadeBy> tracks;
  std::vector<MadeBy> places;
  std::vector<MadeBy> transfers;
  std::vector<MadeBy> work;
  std::vector<MadeBy> sources;
  std::vector<std::uint32_t> inverted;  ///< symbols of inverted sensors, from mark_sensors()
};

/// The location of an entry of a list ("tracks", ...).
description::Pointer material_pointer(std::string_view list, const MadeBy& by);

/// Whether an entry has `for`.
bool for_devices(const description::GivenMaterial& given);

/// `plant` has its units if there is an entry with `for`. O(entries * units).
MadeMaterial make_material(const PlantModel& plant, const description::GivenMaterial& given,
                           description::Faults& faults);

/// Checks the sensors and marks their symbols as Account::senses_parts, except for those of entries that name a
/// symbol that the plant lacks. O(sensors + symbols).
void mark_sensors(PlantModel& plant, MadeMaterial& made, description::Faults& faults);

}  // namespace symplant::model
