// What a name that breaks the rule may have been meant to be.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "name/naming_rule.hpp"

namespace symplant::findings {

/// Line, process, device, direction and task, in upper case; `*` for the one that is not known.
struct NameGuess {
  std::array<std::string, 5> levels;

  std::string path() const;  ///< `LINE_PROC_DEV`; empty where one of these is not known
  std::string name() const;  ///< with `*` in the unknown level's place
};

/// One level that is missing, empty, too many, split, or holds what may not stand in a name. At most a dozen. Empty
/// where the rule is not of those five levels in this order, parted by `_`.
std::vector<NameGuess> guess_names(std::string_view name, const name::NamingRule& rule);

}  // namespace symplant::findings
