// How a link is examined.
#pragma once

#include <atomic>

#include "symplant/tables/time.hpp"

namespace symplant::link::doctor {

struct Options {
  tables::Time duration = 5 * tables::kSecond;  ///< how long values are watched, or a server listens
  bool write_test = false;                      ///< write each event, compare, and restore it
  const std::atomic<bool>* stop = nullptr;      ///< ends it early, with what was found so far; may be null
};

}  // namespace symplant::link::doctor
