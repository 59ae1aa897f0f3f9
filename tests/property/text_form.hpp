// Cases as text, line by line, for reports and fixtures: what is written reads back.
#pragma once

#include <optional>
#include <string>

#include "property/plant_text.hpp"

namespace symplant::property {

/// A word a line says what it is; `#` begins a comment. The page of the form is write_case() itself.
std::string write_case(const Case& the_case);

/// Nothing where the text has a line that is none; `fault` says which then.
std::optional<Case> read_case(const std::string& text, std::string& fault);

}  // namespace symplant::property
