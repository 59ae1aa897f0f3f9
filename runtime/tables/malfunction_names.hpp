// The names of ordinary malfunctions: `EXLINE_MB_AGV stuck`, `EXLINE_MB_AGV slow`, `EXLINE_MB_DOOR_I_OPEN stuck on`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "symplant/tables/malfunction_numbers.hpp"

namespace symplant::tables {

/// The ending of the name of an ordinary malfunction. The longer ones come first: a name is that of the first that
/// fits.
struct OrdinaryMalfunction {
  std::string_view ending;  ///< in upper case
  bool of_symbol;           ///< else of a unit
  bool first;               ///< of a symbol: stuck on; of a unit: stuck
};
inline constexpr std::array kOrdinaryMalfunctions = {
    OrdinaryMalfunction{" STUCK ON", true, true}, OrdinaryMalfunction{" STUCK OFF", true, false},
    OrdinaryMalfunction{" STUCK", false, true}, OrdinaryMalfunction{" SLOW", false, false}};

/// What the name says before the ending, both in upper case; empty if it does not end so.
constexpr std::string_view before_ending(std::string_view name, const OrdinaryMalfunction& ordinary) noexcept {
  return name.ends_with(ordinary.ending) ? name.substr(0, name.size() - ordinary.ending.size()) : std::string_view();
}

/// The number of an ordinary malfunction by its name in upper case. `symbol` and `unit` give the index of a name in
/// upper case, as std::optional. O(1) look-ups.
template <class FindSymbol, class FindUnit>
std::optional<std::uint32_t> ordinary_malfunction(const MalfunctionNumbers& numbers, std::string_view name,
                                                  FindSymbol symbol, FindUnit unit) {
  for (const OrdinaryMalfunction& ordinary : kOrdinaryMalfunctions) {
    const std::string_view of = before_ending(name, ordinary);
    if (of.empty()) continue;
    const std::optional<std::uint32_t> found = ordinary.of_symbol ? symbol(of) : unit(of);
    if (!found) continue;
    if (!ordinary.of_symbol) return ordinary.first ? numbers.stuck(*found) : numbers.slow(*found);
    if (numbers.is_bool_event(*found)) return numbers.stuck(*found, ordinary.first);
  }
  return std::nullopt;
}

}  // namespace symplant::tables
