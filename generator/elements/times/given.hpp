// Times of transitions apart from the devices, as plant.json gives them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/duration.hpp"
#include "elements/times/key.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::description {

/// The times of one transition, or of several that one key means.
struct GivenTime {
  std::string key;  ///< as written
  TimesKey of;
  std::optional<Duration> after = {};
  std::optional<Duration> takes = {};
  std::string text = {};  ///< the value as JSON: two equally specific patterns must agree in it
};

/// An entry of `times`.
struct GivenTimes {
  std::string device;  ///< a name, or a pattern
  std::vector<GivenTime> transitions;
  std::optional<tables::Time> overrun = {};  ///< kNever: not examined
};

}  // namespace symplant::description
