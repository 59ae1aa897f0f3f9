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

/// What an effect of a malfunction does.
enum class MalfunctionKind : std::uint8_t {
  slower,   ///< moves of units take longer, drives of tracks are slower
  stuck,    ///< units are disabled, drives of tracks stop
  force,    ///< symbols have given values
  flicker,  ///< a BOOL symbol shows the opposite from time to time
  lose,     ///< the link of a controller exchanges nothing
  set,      ///< parameters have given numbers
  distort,  ///< a signal is out of adjustment
};

/// An effect of a malfunction. In a field that may be random, a negative number n refers to
/// PlantTables::random_times[-1 - n].
struct EffectRow {
  MalfunctionKind kind = MalfunctionKind::slower;
  Rows of;                    ///< `slower`, `stuck`: of MalfunctionTables::units; `force`: of forces; `set`: of sets
  Rows tracks;                ///< `slower`, `stuck`: of MalfunctionTables::tracks
  std::uint32_t factor = 0;   ///< `slower`: in thousandths, kMinSlower to kMaxSlower
  std::uint32_t subject = 0;  ///< `flicker`: a BOOL symbol; `lose`: a controller; `distort`: a signal; else kNone
  Time every = 0;             ///< `flicker`: until it shows the opposite, >= 1 ns; may be random
  Time shows = 0;             ///< `flicker`: how long it shows the opposite, >= 1 ns
  double gain = 0;            ///< `distort`: the number n becomes n * gain + offset + drift * seconds since the start
  double offset = 0;
  double drift = 0;
};

/// A malfunction of the plant description. Times are >= 1 ns, or 0: not given; they may be random as in an EffectRow.
struct MalfunctionRow {
  Rows effects;                 ///< at least one; they begin in this order
  std::uint32_t condition = 0;  ///< it starts when this begins to hold; kNone: none
  bool during = false;          ///< `while`: it is active exactly as long as the condition holds
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
  bool holds = false;  ///< instead of `value`: what the event shows when the malfunction starts
};

/// A parameter, and the number that it has.
struct MalfunctionSet {
  std::uint32_t value = 0;
  double number = 0;
};

/// The speed of a drive, um/s, of a track that an effect slows or stops.
constexpr std::int64_t slowed_drive(const EffectRow& effect, std::int64_t speed) noexcept {
  if (effect.kind == MalfunctionKind::stuck) return 0;
  const std::int64_t slowed = speed * 1000 / static_cast<std::int64_t>(effect.factor);
  return slowed < -kMaxSpeed ? -kMaxSpeed : slowed > kMaxSpeed ? kMaxSpeed : slowed;
}

/// Empty in a plant whose description has no malfunctions.
struct MalfunctionTables {
  std::span<const MalfunctionRow> rows;
  std::span<const EffectRow> effects;        ///< those of a malfunction are adjacent
  std::span<const MalfunctionUnit> units;    ///< of each effect: ascending by unit
  std::span<const std::uint32_t> tracks;     ///< of each effect: ascending
  std::span<const MalfunctionForce> forces;  ///< of each effect: ascending by symbol
  std::span<const MalfunctionSet> sets;      ///< of each effect: ascending by value
  std::string_view names;                    ///< a malfunction: its name

  bool empty() const noexcept { return rows.empty(); }
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(rows.size()); }
  std::span<const EffectRow> effects_of(std::uint32_t malfunction) const noexcept {
    return effects.subspan(rows[malfunction].effects.first, rows[malfunction].effects.count);
  }
  std::span<const MalfunctionUnit> units_of(const EffectRow& effect) const noexcept {
    const bool of_units = effect.kind == MalfunctionKind::slower || effect.kind == MalfunctionKind::stuck;
    return of_units ? units.subspan(effect.of.first, effect.of.count) : std::span<const MalfunctionUnit>();
  }
  std::span<const std::uint32_t> tracks_of(const EffectRow& effect) const noexcept {
    return tracks.subspan(effect.tracks.first, effect.tracks.count);
  }
  std::span<const MalfunctionForce> forces_of(const EffectRow& effect) const noexcept {
    return effect.kind == MalfunctionKind::force ? forces.subspan(effect.of.first, effect.of.count)
                                                 : std::span<const MalfunctionForce>();
  }
  std::span<const MalfunctionSet> sets_of(const EffectRow& effect) const noexcept {
    return effect.kind == MalfunctionKind::set ? sets.subspan(effect.of.first, effect.of.count)
                                               : std::span<const MalfunctionSet>();
  }
};

}  // namespace symplant::tables
