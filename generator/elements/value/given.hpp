// Values, as plant.json gives them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "symplant/tables/time.hpp"
#include "symplant/tables/value.hpp"

namespace symplant::description {

/// Rows of numbers; empty: not given.
using Matrix = std::vector<std::vector<double>>;

struct GivenChange {
  std::string when;  ///< a condition
  std::string to;    ///< a formula
};

/// The members that a kind does not have are empty.
struct GivenValue {
  std::string name;          ///< with braces if it has `for`
  std::string for_each;      ///< `for`: a pattern of devices; empty: none
  tables::ValueKind kind{};  ///< `parameter`: no key of another kind is given
  std::string unit;
  std::optional<double> start;
  std::optional<double> min;
  std::optional<double> max;
  std::string formula;  ///< of `integral`, `lag`, `ramp`, `delay`, `derivative`, `is`; `position`: the unit
  std::string up;       ///< `ramp`
  std::string down;     ///< `ramp`; empty: as `up`
  std::optional<tables::Time> time;                ///< `lag`, `delay`
  std::vector<std::pair<std::string, double>> at;  ///< `position`: state and number
  double noise = 0;                                ///< the standard deviation
  std::string of;                                  ///< `pid`
  std::string to;                                  ///< `pid`
  double kp = 0;                                   ///< `pid`
  std::optional<tables::Time> ti;                  ///< `pid`
  tables::Time td = 0;                             ///< `pid`
  Matrix a;                                        ///< `linear`; so are the next ones
  Matrix b;
  Matrix c;
  Matrix d;
  std::vector<std::string> u;
  std::vector<double> start_states;
  std::optional<tables::Time> step;   ///< `step`, or `every` of `noise`
  std::optional<tables::Time> trace;  ///< 0: never
  std::vector<GivenChange> changes;
};

}  // namespace symplant::description
