// Requirements as plant.json gives them.
#pragma once

#include <string>

#include "symplant/tables/time.hpp"

namespace symplant::description {

/// A condition that must `never` hold, or one to `expect` `within` a time `after` another began to hold, and not before
/// the `earliest` time. Either `never` or the other two conditions are given. If there is a `for`, names in braces in
/// the texts refer to the matched device.
struct GivenRequirement {
  std::string name;
  std::string never;
  std::string after;
  std::string expect;
  tables::Time within = 0;
  std::string of = {};  ///< `for`: a pattern of devices: each has such a requirement; empty: there is one
  tables::Time earliest = 0;
};

}  // namespace symplant::description
