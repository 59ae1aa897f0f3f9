// Prints JSON in different styles.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "property/dice.hpp"

namespace symplant::property::files {

/// The member of an object that holds the order of its other members; it is not printed.
inline constexpr const char* kOrder = "\n";

/// The value as text. If decorated, members are in any order unless they have one (kOrder), with comments, blanks and
/// escapes between them.
/// `comments` counts them.
std::string print_json(const nlohmann::json& value, bool decorated, Dice dice, long& comments);

}  // namespace symplant::property::files
