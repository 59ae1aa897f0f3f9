// The tables of malfunctions: faults of devices, symbols and links that a run starts and stops (docs/malfunctions.md).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/material.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::tables {

inline constexpr std::uint32_t kMinSlower = 1;          ///< of MalfunctionRow::factor: 0.001
inline constexpr std::uint32_t kMaxSlower = 1'000'000;  ///< 1000
inline constexpr std::uint32_t kOrdinarySlower = 3'000;

enum class MalfunctionKind : std::uint8_t {
  slower,   ///< moves of units take longer
  stuck,    ///< units are disabled
  force,    ///< symbols have given values
  flicker,  ///< a BOOL symbol shows the opposite from time to time
  lose,     ///< the link of a controller exchanges nothing
};

/// A malfunction of the plant description. Times are >= 1 ns, or 0: not given. In a field that may be random, a
/// negative number n refers to PlantTables::random_times[-1 - n].
struct MalfunctionRow {
  MalfunctionKind kind = MalfunctionKind::slower;
  Rows of;                      ///< `slower`, `stuck`: of MalfunctionTables::units; `force`: of forces; else empty
  std::uint32_t factor = 0;     ///< `slower`: in thousandths, kMinSlower to kMaxSlower
  std::uint32_t subject = 0;    ///< `flicker`: a BOOL symbol; `lose`: a controller; else kNone
  Time every = 0;               ///< `flicker`: until it shows the opposite; may be random
  Time shows = 0;               ///< `flicker`: how long it shows the opposite
  std::uint32_t condition = 0;  ///< it starts when this begins to hold; kNone: none
  Time chance = 0;              ///< it starts after this time; may be random
  Time lasts = 0;               ///< it ends after this time; may be random
  Time after = 0;               ///< of `becomes`
  std::uint32_t next = 0;       ///< of `becomes`: the malfunction that starts then; kNone: it becomes no other
  std::uint32_t unless = 0;     ///< of `becomes`: it ends when this condition holds; kNone: none
};

/// A unit of a malfunction, and for `stuck` the state in which it is, or kNoState.
struct MalfunctionUnit {
  std::uint32_t unit = 0;
  std::uint8_t state = 0;
};

/// A symbol, and the value that it has: a bit or a number as it is on the link.
struct MalfunctionForce {
  std::uint32_t symbol = 0;
  std::uint64_t value = 0;
};

/// Empty in a plant whose description has no malfunctions.
struct MalfunctionTables {
  std::span<const MalfunctionRow> rows;
  std::span<const MalfunctionUnit> units;    ///< of each malfunction: ascending by unit
  std::span<const MalfunctionForce> forces;  ///< of each malfunction: ascending by symbol
  std::string_view names;                    ///< a malfunction: its name

  bool empty() const noexcept { return rows.empty(); }
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(rows.size()); }
};

}  // namespace symplant::tables
