// Short texts shared by the messages of a run.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "symplant/exec/exchange.hpp"

namespace symplant::host {

/// `1 step`, `2 steps`.
std::string plural(std::size_t count, std::string_view word);

/// `waiting`, `live`, `lost`.
const char* state_name(exec::LinkState state);

/// A name that is safe on a terminal: control and direction-changing characters as `?`.
std::string shown(std::string_view name);

/// The local date, as 2027-06-30.
std::string today();

}  // namespace symplant::host
