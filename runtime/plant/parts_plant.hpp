// A plant whose parts are put, taken and counted by name.
#pragma once

#include <cstdint>

#include "symplant/plant/device.hpp"

namespace symplant::plant {

/// A plant with a material flow. `Location` enumerates its tracks, then its places; `PartKind` enumerates the kinds.
template <class Symbol, class Location, class PartKind>
class PartsPlant : public NamedPlant<Symbol> {
 public:
  using NamedPlant<Symbol>::NamedPlant;
  using Plant::part;
  using Plant::parts;
  using Plant::put;
  using Plant::take;

  /// Makes a part by hand, on a track at its start. Returns false and does nothing if there is no room (Plant::put).
  bool put(Location location, PartKind kind) noexcept { return put({index(location), tables::kWhole}, index(kind)); }
  /// Makes a part on a track, its middle at `at` um.
  bool put(Location track, std::int64_t at, PartKind kind) noexcept { return put({index(track), at}, index(kind)); }
  /// Removes a part by hand, the one at the end of a track or the one that came first to a place. Returns false and
  /// does nothing if there is no part (Plant::take).
  bool take(Location location) noexcept { return take({index(location), tables::kWhole}); }
  /// Removes the front-most part that covers `at` um of a track.
  bool take(Location track, std::int64_t at) noexcept { return take({index(track), at}); }

  /// The number of parts at a location. O(1).
  std::uint32_t parts(Location location) const noexcept { return parts(index(location)); }
  /// The number of parts of a kind at a location. O(parts at the location).
  std::uint32_t parts(Location location, PartKind kind) const noexcept {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < parts(location); ++i) count += part(location, i).kind == index(kind) ? 1 : 0;
    return count;
  }
  /// A part at a location: 0 is the front-most one on a track, and the one that came first in a place. O(1).
  PartView part(Location location, std::uint32_t number) const noexcept { return part(index(location), number); }
  /// The parts made as a kind, and those that left the plant as that kind (Plant::parts_made). O(1).
  std::uint64_t made(PartKind kind) const noexcept { return this->parts_made(index(kind)); }
  std::uint64_t gone(PartKind kind) const noexcept { return this->parts_gone(index(kind)); }

 private:
  static std::uint32_t index(Location location) noexcept { return static_cast<std::uint32_t>(location); }
  static std::uint32_t index(PartKind kind) noexcept { return static_cast<std::uint32_t>(kind); }
};

}  // namespace symplant::plant
