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

/// The value of a symbol: true, false, or a number as a text.
struct GivenForcedValue {
  std::optional<bool> bit;
  std::string number;  ///< if it is not a bit
  std::string shown;   ///< as it is in the file, for messages
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

struct GivenMalfunction {
  std::string name;
  std::vector<tables::MalfunctionKind> kinds;  ///< those that are given: exactly one, else it has a fault
  std::vector<std::string> of;                 ///< devices, or patterns
  bool of_is_list = false;
  std::uint32_t factor = 0;  ///< of `slower`, in thousandths
  std::string state;         ///< of `stuck`; empty: as it is
  std::vector<std::pair<std::string, GivenForcedValue>> force;
  GivenFlicker flicker;
  std::string lose;  ///< a controller; empty: the only one
  std::string when;  ///< a condition; empty: none
  std::optional<Duration> chance;
  std::optional<Duration> lasts;
  std::optional<GivenBecomes> becomes;
};

}  // namespace symplant::description
