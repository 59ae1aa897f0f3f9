// Where the channels of a map are in the memory of a PLC's inputs and outputs.
#pragma once

#include <cstdint>
#include <vector>

#include "map/channels.hpp"
#include "map/link_view.hpp"

namespace symplant::map {

/// A channel, and the bit or word of the PLC's inputs or outputs at which it begins.
struct PlacedChannel {
  Channel channel;
  std::uint32_t at;

  std::uint32_t at_number(std::uint32_t number) const { return at + (number - channel.first); }
};

/// How the memory of a PLC is built.
enum class IoMemory : std::uint8_t {
  separate,  ///< the bits %IX0.0 to %IX1.7 are not the word %IW0
  overlaid,  ///< they are
};

/// A channel keeps the addresses that its symbols have in the list, if it can transfer all of them at once. Else its
/// first number is its address; if that is taken, the channel follows the last one. No two channels overlap.
/// O(symbols log symbols + channels^2).
std::vector<PlacedChannel> place(const LinkView& view, IoMemory memory);

}  // namespace symplant::map
