// The states of a unit that come next on its shortest sequences to other states.
#pragma once

#include <bitset>
#include <cstdint>

#include "symplant/tables/tables.hpp"

namespace symplant::why {

using States = std::bitset<256>;  ///< of one unit

/// The states that follow `here` on the shortest sequences of transitions to one of `goals`, whatever their conditions.
/// O(transitions + states^2).
States next_states(const tables::TypeRow& type, std::uint8_t here, const States& goals);

}  // namespace symplant::why
