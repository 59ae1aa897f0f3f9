// The malfunctions of a plant as lines of the text format, each begins with `malfunction`.
#pragma once

#include <string>
#include <vector>

#include "elements/malfunction/given.hpp"
#include "property/text_line.hpp"

namespace symplant::property {

std::vector<std::string> malfunction_lines(const std::vector<description::GivenMalfunction>& malfunctions);
/// Reads the words after `word`, which is `malfunction`, or `malfunction-` and a key. Throws std::runtime_error.
void read_malfunction(const std::string& word, Line& line, std::vector<description::GivenMalfunction>& malfunctions);

}  // namespace symplant::property
