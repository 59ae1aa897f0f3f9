// Patterns with `*` and `?`: a second implementation, as simple as possible.
#pragma once

#include <cstddef>
#include <string>

namespace symplant::reference {

bool is_pattern(const std::string& name);
/// Whether the whole text matches, ignoring the case of ASCII letters. Exponential in the number of `*` at worst.
bool fits(const std::string& text, const std::string& pattern);
/// The characters that are neither `*` nor `?`.
std::size_t literals(const std::string& pattern);

}  // namespace symplant::reference
