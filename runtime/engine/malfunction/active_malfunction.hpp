// An active malfunction, as it lies in the flat block.
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::engine {

struct ActiveMalfunction {
  tables::Time since;
  std::uint32_t number;  ///< as tables::MalfunctionNumbers numbers them
  std::uint32_t unused;
};

}  // namespace symplant::engine
