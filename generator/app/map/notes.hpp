// The lines below the table of `symplant map`: sizes, status block, channels, watchdog, policies.
#pragma once

#include <string>

#include "app/map/link_view.hpp"
#include "symplant/link/io_map.hpp"

namespace symplant::app {

/// "coil 1", "holding registers 10-11".
std::string address_text(const link::IoPoint& point);
/// "00002", "40011-40012".
std::string modicon_text(const link::IoPoint& point);
/// "low word first".
std::string word_order_text(link::WordOrder order);

/// The lines about the map of a link.
std::string map_notes(const LinkView& view);

}  // namespace symplant::app
