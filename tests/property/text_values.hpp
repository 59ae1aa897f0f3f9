// The text form of values, signals and `plain`.
#pragma once

#include <string>
#include <vector>

#include "property/text_line.hpp"

namespace symplant::property {

/// Lines of `value`, `value-*`, `signal`, `signal-*` and `plain`.
std::vector<std::string> value_lines(const description::Description& description);

/// Whether a line's first word is one of these.
bool is_value_word(const std::string& word);
/// Reads one of these lines after its first word. Throws std::runtime_error.
void read_value(const std::string& word, Line& line, description::Description& description);

}  // namespace symplant::property
