// What a cycle leaves behind: one change, one finding, one note.
#pragma once

#include <cstdint>

#include "symplant/plant/plant.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::trace {

struct Record {
  enum class Kind : std::uint8_t {
    change,   ///< net change of symbol `of` to `value`: 0 or 1; a value plane's content for a numeric symbol
    unit,     ///< unit `of` is now as `value` says (pack_unit)
    finding,  ///< as tables::Finding has it
    note,     ///< by who drives the plant: `of` and `value` are its own
  };
  tables::Time time = 0;
  std::uint64_t value = 0;
  std::uint32_t of = 0;
  Kind kind = Kind::change;
  tables::FindingKind finding = {};
  bool more = false;  ///< of a finding
  bool last = false;  ///< of its instant
};

/// A unit's doing in one word; what it is about apart from times.
constexpr std::uint64_t pack_unit(const plant::UnitView& unit) noexcept {
  return unit.state | std::uint64_t{unit.target} << 8 | std::uint64_t{unit.moving} << 16 |
         std::uint64_t{unit.stopped_midway} << 17 | std::uint64_t{unit.disabled} << 18 |
         std::uint64_t{unit.frozen} << 19;
}
/// The view that was packed; its times are 0.
constexpr plant::UnitView unpack_unit(std::uint64_t word) noexcept {
  const auto flag = [word](int bit) { return (word >> bit & 1) != 0; };
  return {static_cast<std::uint8_t>(word),
          static_cast<std::uint8_t>(word >> 8),
          flag(16),
          flag(17),
          flag(18),
          flag(19),
          0,
          0.0};
}

}  // namespace symplant::trace
