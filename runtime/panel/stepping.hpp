// The steps of a plant that an operator has frozen.
#pragma once

#include <cstdint>

namespace symplant::panel {

/// The step that a plant runs before it is frozen again.
enum class Stepping : std::uint8_t {
  none,    ///< no step: it does not freeze by itself
  cycle,   ///< one cycle
  change,  ///< to a cycle with a change
};

}  // namespace symplant::panel
