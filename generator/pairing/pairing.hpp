// Joins operations and events that a naming rule has read: facets, each with the symbols of one unit.
#pragma once

#include <span>

#include "name/compiled_naming.hpp"
#include "pairing/facet.hpp"

namespace symplant::pairing {

/// Which facets are made.
enum class Extent {
  linked,   ///< those with an operation that drives an event
  devices,  ///< also those of all other symbols that name a device
};

/// O(inputs) for usual rules; O(archetypes * symbols) within a device.
Pairing pair(const name::CompiledNaming& naming, std::span<const Input> inputs, Extent extent);

}  // namespace symplant::pairing
