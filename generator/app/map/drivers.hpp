// What drives each symbol of a map, in words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/map/link_view.hpp"

namespace symplant::app {

/// The device that sets an event, itself or by its custom behavior, "a condition", or "the PLC" for an operation.
/// Nothing if no device drives the event.
std::optional<std::string> driven_by(const LinkView& view, std::uint32_t symbol);

/// The device that an operation moves.
std::optional<std::string> moved_device(const LinkView& view, std::uint32_t symbol);

/// What reads an operation without being moved by it: devices, requirements, events that follow a condition, and "plant
/// time" for the link's clock. O(readers).
std::vector<std::string> readers_of(const LinkView& view, std::uint32_t symbol);

/// The cell of the table: "EXLINE_MB_AGV", "the PLC, moves EXLINE_MB_AGV", "the PLC, read by A and 2 more", `-`.
std::string driver_text(const LinkView& view, std::uint32_t symbol);

}  // namespace symplant::app
