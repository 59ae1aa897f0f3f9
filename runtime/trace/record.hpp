// One record of a run: a change, a finding or a note.
#pragma once

#include <cstdint>

#include "symplant/plant/plant.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::trace {

struct Record {
  enum class Kind : std::uint8_t {
    change,       ///< net change of symbol `of` to `value`: 0 or 1; for a number as in its value slot
    unit,         ///< state of unit `of` (unpack_unit) and remaining time of its move (remaining_of), both in `value`
    finding,      ///< as in tables::Finding
    note,         ///< of the program that drives the plant, which defines `of` and `value`
    part,         ///< part `value` is of kind `of`; `more`: by hand. The next record is its part_move
    part_move,    ///< of the part before: from and to in `value` (pack_move), its front in um in `of`
    value,        ///< output `of` of a value is the double with the bits `value`
    malfunction,  ///< malfunction `of` started if `more`, else it ended, by `value` (engine::MalfunctionChange::By)
    // Only of a recorder of motions:
    track,       ///< the parts of track `of` moved: `value` parts follow from the front, two records each
    part_at,     ///< part `value` is of kind `of`
    part_speed,  ///< of the part before: its front at `value` um, its speed `of` in um/s, both in two's complement
  };
  tables::Time time = 0;
  std::uint64_t value = 0;
  std::uint32_t of = 0;
  Kind kind = Kind::change;
  tables::FindingKind finding = {};
  bool more = false;  ///< as in tables::Finding
  bool last = false;  ///< the last record of its instant
};

/// The `of` of a note before the first record of a further instant at the same time: its value is the number of the
/// instant, from 2.
inline constexpr std::uint32_t kInstantNote = 0xFFFF'FFF8;
/// The `of` of a note about what is done to the plant before its next instant: its value is the index of a step of what
/// is played.
inline constexpr std::uint32_t kActNote = 0xFFFF'FFF7;
/// The `of` of a note about the link of a device with a behavior: its value is twice the index in
/// PlantTables::behaviour_units, and 1 more if the link is now connected.
inline constexpr std::uint32_t kQualityNote = 0xFFFF'FFF6;

/// Locations in one word; kNone: it was made, or changed its kind.
constexpr std::uint64_t pack_move(std::uint32_t from, std::uint32_t to) noexcept {
  return std::uint64_t{from} << 32 | to;
}

/// A change of a part, from its two records.
struct PartRecord {
  tables::Time time;
  std::uint64_t number;
  std::uint32_t kind;
  std::uint32_t from;  ///< kNone: it was made, or changed its kind
  std::uint32_t to;    ///< a location, or kOut; kNone with kNone in `from`: it changed its kind
  std::uint32_t x;     ///< um
  bool by_hand;

  bool made() const noexcept { return from == tables::kNone && to != tables::kNone; }
  bool changed() const noexcept { return from == tables::kNone && to == tables::kNone; }
};

constexpr PartRecord part_record(const Record& part, const Record& move) noexcept {
  return {part.time,
          part.value,
          part.of,
          static_cast<std::uint32_t>(move.value >> 32),
          static_cast<std::uint32_t>(move.value),
          move.of,
          part.more};
}

/// Record::value of the finding `part blocked`: the part that cannot move, and the part that takes up its room.
constexpr std::uint64_t pack_parts(std::uint64_t part, std::uint64_t obstacle) noexcept {
  return part << 32 | (obstacle & 0xFFFF'FFFF);
}

/// The state of a unit in one word, without its times.
constexpr std::uint64_t pack_unit(const plant::UnitView& unit) noexcept {
  return unit.state | std::uint64_t{unit.target} << 8 | std::uint64_t{unit.moving} << 16 |
         std::uint64_t{unit.stopped_midway} << 17 | std::uint64_t{unit.disabled} << 18 |
         std::uint64_t{unit.frozen} << 19;
}
inline constexpr int kUnitBits = 20;  ///< of pack_unit()

/// The value of a record of a unit: its state, and above it the remaining travel time in us, rounded down.
constexpr std::uint64_t pack_motion(const plant::UnitView& unit) noexcept {
  constexpr std::uint64_t kMost = (std::uint64_t{1} << (64 - kUnitBits)) - 1;  // half a year
  const auto left = static_cast<std::uint64_t>(unit.remaining / tables::kMicrosecond);
  return pack_unit(unit) | (left < kMost ? left : kMost) << kUnitBits;
}
/// What is left of a move according to such a value, ns.
constexpr tables::Time remaining_of(std::uint64_t word) noexcept {
  return static_cast<tables::Time>(word >> kUnitBits) * tables::kMicrosecond;
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
          0,
          0.0};
}

}  // namespace symplant::trace
