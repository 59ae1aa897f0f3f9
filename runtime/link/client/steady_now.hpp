// The steady clock in nanoseconds, as the threads of links use it.
#pragma once

#include <chrono>

#include "symplant/tables/time.hpp"

namespace symplant::link::client {

inline tables::Time steady_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace symplant::link::client
