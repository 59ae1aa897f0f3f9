// What a PLC has confirmed of the events, and what has changed since.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/image/map.hpp"

namespace symplant::link::client {

/// Only bits of the mapped symbols and of the status are ever changes. A call costs one step for each 64 bits of the
/// planes.
class Outbox {
 public:
  Outbox(const tables::PlantTables& tables, const image::Map& map);

  /// From now on everything mapped is a change, until it is confirmed.
  void forget() noexcept;
  /// The bits of these lanes do not count as changes until release() or restart().
  void hold(std::span<const LaneChange> lanes) noexcept;
  void release(std::span<const LaneChange> lanes) noexcept;
  /// Forgets what was confirmed and held.
  void restart() noexcept;
  /// The bits of these lanes are changes again, until they are confirmed.
  void forget(std::span<const LaneChange> lanes) noexcept;
  /// All lanes whose mapped bits differ from what was confirmed last, in ascending order. Valid until the next call.
  std::span<const LaneChange> changes(const Events& events);
  /// The PLC has accepted the changes.
  void confirm(std::span<const LaneChange> changes) noexcept;
  /// The lanes whose bits, as read back, differ from what the PLC confirmed.
  std::vector<LaneChange> differences(const Events& read_back) const;

 private:
  /// One plane: its mapped bits, the confirmed values, the bits whose confirmed value is known, and the bits on hold().
  struct Side {
    Plane plane = Plane::event_bits;
    std::vector<std::uint64_t> mapped;
    std::vector<std::uint64_t> confirmed;
    std::vector<std::uint64_t> known;
    std::vector<std::uint64_t> held;
  };

  Side& side_of(const Lane& lane) noexcept;

  std::array<Side, 2> sides_;
  std::vector<LaneChange> changes_;
};

}  // namespace symplant::link::client
