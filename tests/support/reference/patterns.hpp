// Patterns with `*` and `?`: a second implementation, as simple as possible.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace symplant::reference {

bool is_pattern(const std::string& name);
/// Whether the whole text matches, ignoring the case of ASCII letters. Exponential in the number of `*` at worst.
bool fits(const std::string& text, const std::string& pattern);
/// The runs that the `*` and `?` match, from left to right, each as short as those before it allow. Empty if the
/// pattern does not match.
std::vector<std::string> shares(const std::string& text, const std::string& pattern);
/// The characters that are neither `*` nor `?`.
std::size_t literals(const std::string& pattern);

}  // namespace symplant::reference
