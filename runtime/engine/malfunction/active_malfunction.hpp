// An active malfunction, as it lies in the flat block.
#pragma once

#include <cstdint>

#include "symplant/engine/instant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

struct ActiveMalfunction {
  tables::Time since;
  std::uint32_t number;      ///< as tables::MalfunctionNumbers numbers them
  MalfunctionChange::By by;  ///< what started it
  std::uint8_t unused[3];
};

}  // namespace symplant::engine
