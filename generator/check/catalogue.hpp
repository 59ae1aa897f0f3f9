// Every rule of the tool, those of reading included.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diag/diagnostic.hpp"

namespace symplant::check {

/// By id.
std::vector<const diag::RuleInfo*> catalogue();

/// The rule of an id (`SP201`) or slug, without regard to case; null for an unknown one.
const diag::RuleInfo* find_rule(std::string_view id_or_slug);

/// For a message: that no rule has this name, and the nearest one.
std::string no_such_rule(std::string_view name);

}  // namespace symplant::check
