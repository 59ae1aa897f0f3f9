// Cases as text, line by line, for reports and fixtures: written text reads back the same.
#pragma once

#include <optional>
#include <string>

#include "property/plant_text.hpp"

namespace symplant::property {

/// The first word of a line is its kind; `#` starts a comment. write_case() defines the format.
std::string write_case(const Case& the_case);

/// Nothing if the text has an invalid line; `fault` then says which.
std::optional<Case> read_case(const std::string& text, std::string& fault);

}  // namespace symplant::property
