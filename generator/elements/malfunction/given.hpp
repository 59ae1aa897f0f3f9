// The malfunctions of a plant description, as the user wrote them: names and conditions are texts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "description/duration.hpp"
#include "symplant/tables/malfunction.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::description {

/// The value of a symbol: true, false, a number as a text, or what it shows when the malfunction starts.
struct GivenForcedValue {
  std::optional<bool> bit;
  std::string number;  ///< if it is not a bit
  std::string shown;   ///< as it is in the file, for messages
  bool holds = false;  ///< it is `"hold"`
};

struct GivenFlicker {
  std::string symbol;
  std::optional<Duration> every;
  tables::Time shows = 0;  ///< `for`
};

struct GivenBecomes {
  tables::Time after = 0;
  std::string unless;  ///< a condition; empty: none
  std::string start;   ///< a malfunction
};

struct GivenDistort {
  std::string symbol;
  double gain = 1;
  double offset = 0;
  double drift = 0;  ///< a second
};

/// What a malfunction does: one of several, or all of it.
struct GivenEffect {
  std::vector<tables::MalfunctionKind> kinds;  ///< those that are given: exactly one, else it has a fault
  std::vector<std::string> of;                 ///< devices and tracks, or patterns
  bool of_is_list = false;
  std::uint32_t factor = 0;  ///< of `slower`, in thousandths
  std::string state;         ///< of `stuck`; empty: as it is
  std::vector<std::pair<std::string, GivenForcedValue>> force;
  GivenFlicker flicker;
  std::string lose;  ///< a controller; empty: the only one
  std::vector<std::pair<std::string, double>> set;
  GivenDistort distort;
};

struct GivenMalfunction {
  std::string name;
  GivenEffect one;                   ///< without `effects`: what it does; with it: only `of` is given
  std::vector<GivenEffect> effects;  ///< empty: there is only `one`
  std::string when;                  ///< a condition; empty: none
  bool during = false;               ///< the condition is that of `while`
  std::optional<Duration> chance;
  std::optional<Duration> lasts;
  std::optional<GivenBecomes> becomes;
};

}  // namespace symplant::description
