// Joins operations and events that a naming rule has read: facets, each with the symbols of one unit.
#pragma once

#include <span>

#include "name/compiled_naming.hpp"
#include "pairing/facet.hpp"

namespace symplant::pairing {

/// O(inputs) for usual rules; O(archetypes * symbols) within a device.
Pairing pair(const name::CompiledNaming& naming, std::span<const Input> inputs);

}  // namespace symplant::pairing
