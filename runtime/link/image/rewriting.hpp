// Tracks what a PLC has written, and whether it has written all of it again after a loss of its link.
#pragma once

#include <array>
#include <cstdint>

#include "symplant/link/image/position_set.hpp"

namespace symplant::link::image {

/// For bits and numbers: coils and holding registers of Modbus, positions of other protocols. Used by the server's
/// thread. A write costs one step for each 64 addresses written, a loss one for each 64 addresses of both.
class Rewriting {
 public:
  Rewriting(std::uint32_t bits, std::uint32_t numbers) : parts_{Written(bits), Written(numbers)} {}

  /// A loss: from now on all mapped addresses that were written before are awaited.
  void begin(const PositionSet& mapped_bits, const PositionSet& mapped_numbers) noexcept {
    parts_[0].awaited.assign_common(parts_[0].ever, mapped_bits);
    parts_[1].awaited.assign_common(parts_[1].ever, mapped_numbers);
    awaited_ = parts_[0].awaited.size() + parts_[1].awaited.size();
  }
  void wrote(bool bits, std::uint32_t first, std::uint32_t count) noexcept {
    Written& part = parts_[bits ? 0 : 1];
    part.ever.add(first, count);
    if (awaited_ != 0) awaited_ -= part.awaited.remove(first, count);
  }
  /// Whether nothing is awaited.
  bool complete() const noexcept { return awaited_ == 0; }

 private:
  struct Written {
    explicit Written(std::uint32_t size) : ever(size), awaited(size) {}
    PositionSet ever;
    PositionSet awaited;
  };

  std::array<Written, 2> parts_;
  std::uint32_t awaited_ = 0;
};

}  // namespace symplant::link::image
