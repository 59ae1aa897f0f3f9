// What drives each symbol of a map, in words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map/link_view.hpp"

namespace symplant::map {

/// The device that sets an event, itself or by its custom behavior, "a condition", or "the PLC" for an operation.
/// Nothing if no device drives the event.
std::optional<std::string> driven_by(const LinkView& view, std::uint32_t symbol);

/// The device that an operation moves.
std::optional<std::string> moved_device(const LinkView& view, std::uint32_t symbol);

/// What reads an operation without being moved by it: as why::reader_words(), and "plant time" for the link's clock.
/// O(readers).
std::vector<std::string> readers_of(const LinkView& view, std::uint32_t symbol);

/// What an operation drives: as why::driven_things(), and "plant time" for the link's clock. Empty for an event.
std::vector<std::string> driven_things(const LinkView& view, std::uint32_t symbol);

/// The cell of `driven by`: "EXLINE_MB_AGV", "a condition", "the PLC", `-`.
std::string driver_text(const LinkView& view, std::uint32_t symbol);

/// The cell of `drives`: "EXLINE_MB_AGV", "L_P_CV, track CV1", "A, B, C and 2 more", "- (read by requirement slow)",
/// `-`; empty for an event.
std::string drives_text(const LinkView& view, std::uint32_t symbol);

}  // namespace symplant::map
