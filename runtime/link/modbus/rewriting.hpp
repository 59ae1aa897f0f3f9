// Tracks what a PLC has written, and whether it has written all of it again after a loss of its link.
#pragma once

#include <array>
#include <cstdint>

#include "symplant/link/image/position_set.hpp"

namespace symplant::link::modbus {

/// For coils and holding registers. Used by the server's thread. A write costs one step for each 64 addresses written,
/// a loss one for each 64 addresses of the tables.
class Rewriting {
 public:
  Rewriting(std::uint32_t coils, std::uint32_t holding_registers)
      : tables_{Written(coils), Written(holding_registers)} {}

  /// A loss: from now on all mapped addresses that were written before are awaited.
  void begin(const image::PositionSet& mapped_coils, const image::PositionSet& mapped_registers) noexcept {
    tables_[0].awaited.assign_common(tables_[0].ever, mapped_coils);
    tables_[1].awaited.assign_common(tables_[1].ever, mapped_registers);
    awaited_ = tables_[0].awaited.size() + tables_[1].awaited.size();
  }
  void wrote(bool coils, std::uint32_t first, std::uint32_t count) noexcept {
    Written& table = tables_[coils ? 0 : 1];
    table.ever.add(first, count);
    if (awaited_ != 0) awaited_ -= table.awaited.remove(first, count);
  }
  /// Whether nothing is awaited.
  bool complete() const noexcept { return awaited_ == 0; }

 private:
  struct Written {
    explicit Written(std::uint32_t size) : ever(size), awaited(size) {}
    image::PositionSet ever;
    image::PositionSet awaited;
  };

  std::array<Written, 2> tables_;
  std::uint32_t awaited_ = 0;
};

}  // namespace symplant::link::modbus
