// Small texts that a run's messages share.
#pragma once

#include <string>
#include <string_view>

#include "symplant/core/time.hpp"

namespace symplant::host {

/// Plant time as people write it: `1.5 s`.
std::string seconds(core::Time time);

/// `1 step`, `2 steps`.
std::string plural(std::size_t count, std::string_view word);

/// A name as a terminal may show it: control and direction-changing characters as `?`.
std::string shown(std::string_view name);

}  // namespace symplant::host
