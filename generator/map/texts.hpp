// Texts of numbers on a link.
#pragma once

#include <cstdint>
#include <string>

#include "symplant/link/modbus/io_map.hpp"

namespace symplant::map {

/// "100", "104-105".
std::string range_text(std::uint32_t first, std::uint32_t count);
/// "00002", "40011-40012".
std::string modicon_text(const link::modbus::IoPoint& point);
/// "low word first".
std::string word_order_text(link::WordOrder order);

}  // namespace symplant::map
