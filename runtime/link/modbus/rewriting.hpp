// What a PLC has written, and whether after a loss of its link it has written all of it again.
#pragma once

#include <array>
#include <cstdint>

#include "symplant/link/modbus/place_set.hpp"

namespace symplant::link::modbus {

/// Of coils and holding registers. Used by the server's thread. Costs a step for each 64 places written; a loss costs
/// one for each 64 places that there are.
class Rewriting {
 public:
  Rewriting(std::uint32_t coils, std::uint32_t holding_registers)
      : tables_{Written(coils), Written(holding_registers)} {}

  /// A loss: all that was written until now is awaited, of the places that something stands on.
  void begin(const PlaceSet& mapped_coils, const PlaceSet& mapped_registers) noexcept {
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
    PlaceSet ever;
    PlaceSet awaited;
  };

  std::array<Written, 2> tables_;
  std::uint32_t awaited_ = 0;
};

}  // namespace symplant::link::modbus
