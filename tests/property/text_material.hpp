// The material flow of a plant as lines of the text format, each begins with `material`.
#pragma once

#include <string>
#include <vector>

#include "elements/material/given.hpp"
#include "property/text_line.hpp"

namespace symplant::property {

/// Without `for`: random plants have none.
std::vector<std::string> material_lines(const description::GivenMaterial& material);
/// Reads the words after `material`. Throws std::runtime_error.
void read_material(Line& line, description::GivenMaterial& material);

}  // namespace symplant::property
