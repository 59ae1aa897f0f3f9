// The models of archetypes, expressed as descriptions of devices.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "pairing/work.hpp"

namespace symplant::pairing {

/// The symbols of an archetype, by role; kNone where a role has no symbol.
using RoleInputs = std::array<std::uint32_t, name::kArchetypeRoles>;

bool is_operation_role(name::ArchetypeRole role);

/// Members, states and base of a facet. Not for `constant`.
Facet archetype_facet(const name::Archetype& archetype, const RoleInputs& roles, std::span<const Input> inputs);

}  // namespace symplant::pairing
