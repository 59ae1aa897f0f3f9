// Symbols that follow a condition, as plant.json gives them.
#pragma once

#include <string>

namespace symplant::description {

/// An input that no device drives and that follows a condition.
struct GivenFollow {
  std::string symbol;  ///< a name, or a pattern
  std::string condition;
  std::string off = {};  ///< a condition that switches it off; empty: none
};

}  // namespace symplant::description
