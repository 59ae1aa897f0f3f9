// The lines below the table of `symplant map`: sizes, status block, channels, watchdog, policies.
#pragma once

#include <string>

#include "map/link_view.hpp"

namespace symplant::map {

/// The lines about the map of a link.
std::string map_notes(const LinkView& view);

}  // namespace symplant::map
