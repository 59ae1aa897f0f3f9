// The layout of the status block: what its input registers hold.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace symplant::link {

/// A number in the status block; a number of several registers has the link's word order.
struct StatusField {
  std::uint8_t first;      ///< index of its first register in the block
  std::uint8_t registers;  ///< 1, 2 or 4
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

}  // namespace symplant::link
