// The variables of a VCD file: their scopes, names and identifiers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// The short name by which changes name variable `number`: printable, without blanks.
std::string vcd_identifier(std::size_t number);

/// A name without what would end it in the file, or for GTKWave: blanks as `_`, what is not ASCII as `u00FC`.
std::string vcd_name(std::string_view name);

/// A text as a string value: blanks, control characters, backslashes and what is not ASCII as GTKWave reads them back
/// (`\x20`); as they are they would end its reading of the file.
std::string vcd_string(std::string_view text);

/// From $version to $enddefinitions. Symbol s is variable s, the state of unit u, by its path, is variable symbols + u.
/// A unit's scope is its path, level by level; what is of no unit stands in the plant's.
std::string vcd_header(const PlantNames& names);

}  // namespace symplant::trace
