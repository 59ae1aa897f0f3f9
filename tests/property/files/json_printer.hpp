// Prints JSON in different styles.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "property/dice.hpp"

namespace symplant::property::files {

/// The value as text. If decorated, members are in any order, with comments, blanks and escapes between them.
/// `comments` counts them.
std::string print_json(const nlohmann::json& value, bool decorated, Dice dice, long& comments);

}  // namespace symplant::property::files
