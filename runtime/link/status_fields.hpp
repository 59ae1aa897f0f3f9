// The status of the plant that a link may carry: its numbers, in their order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace symplant::link {

/// A number of the status. A protocol of 16-bit words puts the words of all fields in a row, those of one number in its
/// word order.
struct StatusField {
  std::uint8_t first;  ///< number of words before it
  std::uint8_t words;  ///< of 16 bits: 1, 2 or 4; a counter is truncated to this size, so it wraps around
  std::string_view name;
  std::string_view meaning;
};

inline constexpr std::array kStatusFields = {
    StatusField{0, 1, "layout", "version of this layout: 1"},
    StatusField{1, 1, "heartbeat", "number of cycles, wraps around"},
    StatusField{2, 1, "state", "0 waiting, 1 run, 2 link lost, 3 frozen, 4 stopping"},
    StatusField{3, 1, "quality", "one bit for each link, in order, 1 while it is live"},
    StatusField{4, 2, "lost exchanges", "of this link, since the start"},
    StatusField{6, 2, "overruns", "cycles that ended after their deadline, since the start"},
    StatusField{8, 4, "map hash", "digest of this map"},
};

/// Words of all fields.
inline constexpr std::uint32_t kStatusWords = kStatusFields.back().first + kStatusFields.back().words;
inline constexpr std::size_t kStateField = 2;

}  // namespace symplant::link
