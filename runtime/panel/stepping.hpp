// The steps of a plant that an operator has frozen.
#pragma once

#include <cstdint>

namespace symplant::panel {

/// A plant that runs a step, and is then frozen.
enum class Stepping : std::uint8_t {
  none,    ///< it runs on
  cycle,   ///< one cycle
  change,  ///< to a cycle with a change
};

}  // namespace symplant::panel
