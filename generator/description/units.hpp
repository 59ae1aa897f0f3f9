// Lengths and speeds of a plant description.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "description/json_entry.hpp"

namespace symplant::description {

/// A length of at most 1 km, in um. Nothing, and a fault, for other texts.
std::optional<std::int64_t> length_of(const std::string& text, const Pointer& here, ShapeFaults& faults);
/// Like length_of(), for a length above 0.
std::optional<std::int64_t> length_above_zero(const std::string& text, const Pointer& here, ShapeFaults& faults);

/// A speed above 0 and of at most 100 m/s, in um/s. Nothing, and a fault, for other texts.
std::optional<std::int64_t> speed_of(const std::string& text, const Pointer& here, ShapeFaults& faults);

}  // namespace symplant::description
