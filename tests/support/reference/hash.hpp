// The digest of a world's logical state (docs/engine.md, "What state_hash digests").
#pragma once

#include <cstdint>

#include "support/reference/rules.hpp"
#include "support/reference/world.hpp"

namespace symplant::reference {

std::uint64_t state_hash(const Rules& rules, const World& world);

}  // namespace symplant::reference
