// Reads all symbols of a PLC, and notes when each one was read.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::record {

/// A symbol as it was read last.
struct Reading {
  std::uint32_t symbol = 0;
  std::uint64_t value = 0;  ///< as in the plant's value slots; of a BOOL 0 or 1
  tables::Time time = 0;    ///< the middle between its request and the answer, by the steady clock in ns
  bool is_read = false;     ///< by the latest image: its request was not refused
};

/// Reads over a dialog that is open; writes nothing. Used by one thread.
class ImageReader final : private client::ReadObserver {
 public:
  /// The arguments must outlive it.
  ImageReader(client::Dialog& dialog, const tables::PlantTables& tables, const image::Map& map);

  /// Reads operations, then events. A fault of the transport ends the connection; what the PLC refuses is no fault.
  /// O(requests * points).
  client::Fault read(tables::Time now);

  /// In the order of the map. Valid until the next call.
  std::span<const Reading> readings() const noexcept { return readings_; }
  /// The time of the latest answer, and of the request that was sent first.
  tables::Time first_sent() const noexcept { return first_sent_; }
  tables::Time last_answered() const noexcept { return last_answered_; }

 private:
  /// One direction: what was read, and which of it by the latest request.
  struct Side {
    Plane bits_plane;
    Plane numbers_plane;
    std::vector<std::uint32_t> points;  ///< indexes in the map
    std::vector<std::uint64_t> bits = {};
    std::vector<std::uint64_t> numbers = {};
    std::vector<std::uint64_t> marked_bits = {};
    std::vector<std::uint64_t> marked_numbers = {};

    client::Words words() { return {bits, numbers}; }
  };

  client::Words marks() noexcept override { return {side_->marked_bits, side_->marked_numbers}; }
  void answered(tables::Time sent, tables::Time answered) override;

  client::Dialog& dialog_;
  const tables::PlantTables& tables_;
  const image::Map& map_;
  std::array<Side, 2> sides_;
  Side* side_ = nullptr;  ///< which is being read
  std::vector<Reading> readings_;
  tables::Time first_sent_ = 0;
  tables::Time last_answered_ = 0;
};

}  // namespace symplant::link::record
