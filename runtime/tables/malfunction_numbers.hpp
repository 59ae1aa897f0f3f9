// The numbers of malfunctions: those of the plant description, then the ordinary ones that every plant has.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// The maximum number of ordinary malfunctions that are active at a time.
inline constexpr std::uint32_t kMostOrdinaryMalfunctions = 64;

/// With n written malfunctions and U units: the written ones have the numbers 0 to n - 1; unit u is stuck by n + 2u and
/// three times slower by n + 2u + 1; the bit of symbol k is off by n + 2U + 2k and on by n + 2U + 2k + 1, if it is a
/// BOOL event. All members O(1) unless noted.
class MalfunctionNumbers {
 public:
  explicit constexpr MalfunctionNumbers(const PlantTables& tables) noexcept
      : tables_(tables),
        written_(static_cast<std::uint32_t>(tables.malfunctions.rows.size())),
        first_symbol_(written_ + 2 * static_cast<std::uint32_t>(tables.units.size())) {}

  std::uint32_t stuck(std::uint32_t unit) const noexcept { return written_ + 2 * unit; }
  std::uint32_t slow(std::uint32_t unit) const noexcept { return written_ + 2 * unit + 1; }
  std::uint32_t stuck(std::uint32_t symbol, bool on) const noexcept {
    return first_symbol_ + 2 * symbol + (on ? 1 : 0);
  }

  bool is_written(std::uint32_t number) const noexcept { return number < written_; }
  bool exists(std::uint32_t number) const noexcept {
    if (number < first_symbol_) return true;
    const std::uint32_t of = (number - first_symbol_) / 2;
    return of < tables_.symbols.size() && is_bool_event(of);
  }
  bool is_bool_event(std::uint32_t symbol) const noexcept {
    const SymbolRow& row = tables_.symbols[symbol];
    return row.type() == DataType::boolean && row.direction() == Direction::event;
  }

  /// Whether an ordinary malfunction is of a unit; otherwise it is of a symbol.
  constexpr bool is_of_unit(std::uint32_t number) const noexcept { return number < first_symbol_; }
  std::uint32_t unit(std::uint32_t number) const noexcept { return (number - written_) / 2; }
  std::uint32_t symbol(std::uint32_t number) const noexcept { return (number - first_symbol_) / 2; }
  constexpr bool is_on(std::uint32_t number) const noexcept { return (number - first_symbol_) % 2 != 0; }

  /// What an ordinary malfunction does: it is a `stuck` or `slower` of a unit, or a `force` of a symbol.
  constexpr MalfunctionKind ordinary_kind(std::uint32_t number) const noexcept {
    if (!is_of_unit(number)) return MalfunctionKind::force;
    return (number - written_) % 2 == 0 ? MalfunctionKind::stuck : MalfunctionKind::slower;
  }

  /// What the name of an ordinary malfunction has after that of its unit or symbol.
  constexpr std::string_view ordinary_name(std::uint32_t number) const noexcept {
    if (!is_of_unit(number)) return is_on(number) ? "stuck on" : "stuck off";
    return ordinary_kind(number) == MalfunctionKind::stuck ? "stuck" : "slow";
  }

  /// Whether a malfunction has an effect of this kind, `slower` or `stuck`, on a unit. O(effects * log their units).
  bool acts_on(std::uint32_t number, MalfunctionKind kind, std::uint32_t unit) const noexcept {
    if (!is_written(number)) return is_of_unit(number) && ordinary_kind(number) == kind && this->unit(number) == unit;
    const auto effects = tables_.malfunctions.effects_of(number);
    return std::any_of(effects.begin(), effects.end(),
                       [&](const EffectRow& effect) { return effect.kind == kind && names_unit(effect, unit); });
  }
  /// Whether a malfunction has an effect of this kind, `slower` or `stuck`, on a track. O(effects * log their tracks).
  bool acts_on_track(std::uint32_t number, MalfunctionKind kind, std::uint32_t track) const noexcept {
    if (!is_written(number)) return false;
    const auto effects = tables_.malfunctions.effects_of(number);
    return std::any_of(effects.begin(), effects.end(),
                       [&](const EffectRow& effect) { return effect.kind == kind && names_track(effect, track); });
  }
  /// Whether an effect names a unit. O(log its units).
  bool names_unit(const EffectRow& effect, std::uint32_t unit) const noexcept {
    const auto units = tables_.malfunctions.units_of(effect);
    const auto found = std::lower_bound(units.begin(), units.end(), unit,
                                        [](const MalfunctionUnit& a, std::uint32_t b) { return a.unit < b; });
    return found != units.end() && found->unit == unit;
  }
  /// Whether an effect slows or stops a track. O(log its tracks).
  bool names_track(const EffectRow& effect, std::uint32_t track) const noexcept {
    const auto tracks = tables_.malfunctions.tracks_of(effect);
    return std::binary_search(tracks.begin(), tracks.end(), track);
  }
  /// Calls `function(symbol)` for each symbol that a malfunction forces or lets flicker, in the order of its effects.
  template <class Function>
  void for_symbols(std::uint32_t number, Function function) const {
    if (!is_written(number)) {
      if (!is_of_unit(number)) function(symbol(number));
      return;
    }
    for (const EffectRow& effect : tables_.malfunctions.effects_of(number)) {
      if (effect.kind == MalfunctionKind::flicker) function(effect.subject);
      for (const MalfunctionForce& force : tables_.malfunctions.forces_of(effect)) function(force.symbol);
    }
  }
  /// Whether a malfunction cuts the link of a controller. O(effects).
  bool cuts(std::uint32_t number, std::uint32_t controller) const noexcept {
    if (!is_written(number)) return false;
    const auto effects = tables_.malfunctions.effects_of(number);
    return std::any_of(effects.begin(), effects.end(), [controller](const EffectRow& effect) {
      return effect.kind == MalfunctionKind::lose && effect.subject == controller;
    });
  }

 private:
  const PlantTables& tables_;
  std::uint32_t written_;
  std::uint32_t first_symbol_;
};

/// Finding::of of the first malfunction in an instantaneous loop. Units, follows and material come before it. O(1).
inline std::uint32_t first_malfunction_of_loop(const PlantTables& tables) noexcept {
  const MaterialTables& material = tables.material;
  return static_cast<std::uint32_t>(tables.units.size() + tables.follows.size() + material.tracks.size() +
                                    material.transfers.size() + material.work.size() + material.sources.size());
}

/// Finding::of of the first value in an instantaneous loop, after the malfunctions. O(1).
inline std::uint32_t first_value_of_loop(const PlantTables& tables) noexcept {
  return first_malfunction_of_loop(tables) + tables.malfunctions.size();
}

}  // namespace symplant::tables
