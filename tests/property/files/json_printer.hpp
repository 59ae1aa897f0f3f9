// JSON as different people write it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "property/dice.hpp"

namespace symplant::property::files {

/// The value as text. Where it is decorated members stand in any order, with comments, blanks and escapes between.
/// `comments` counts them.
std::string print_json(const nlohmann::json& value, bool decorated, Dice dice, long& comments);

}  // namespace symplant::property::files
