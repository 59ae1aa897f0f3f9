// Finds archetypes: texts of operations and events that follow each other within a device.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "infer/evaluate.hpp"
#include "name/naming.hpp"

namespace symplant::infer {

struct FoundArchetype {
  name::Archetype archetype;
  std::size_t support = 0;
};

/// Archetypes for what `applied` leaves unpaired, the best supported first. O(samples).
std::vector<FoundArchetype> archetypes_of(const Applied& applied, std::span<const Sample> samples,
                                          const name::CompiledNaming& naming);

/// Adds the archetypes that pair symbols. Handshakes with the same `done` are joined.
name::Naming with_archetypes(const name::Naming& naming, std::span<const Sample> samples,
                             std::vector<std::string>& steps);

}  // namespace symplant::infer
