// The variables of a VCD file: their scopes, names and identifiers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// The identifier of variable `number` in changes: short, printable, without blanks.
std::string vcd_identifier(std::size_t number);

/// A name with the characters that the file or GTKWave cannot read replaced: blanks as `_`, non-ASCII as `u00FC`.
std::string vcd_name(std::string_view name);

/// A text as a string value: blanks, control characters, backslashes and non-ASCII bytes escaped as `\x20`. GTKWave
/// reads these escapes; without them it stops reading the file.
std::string vcd_string(std::string_view text);

/// The number of the variable of the first written malfunction. Variables of symbols, units and locations come before
/// it.
std::size_t first_malfunction(const tables::PlantTables& tables);

/// The number of the variable of the first output of a value, after the malfunctions.
std::size_t first_output(const tables::PlantTables& tables);

/// The header, from $version to $enddefinitions. Symbol s is variable s, the state of unit u is variable (number of
/// symbols) + u. A unit's scope is its path, level by level; symbols without a unit are in the scope of the plant, and
/// written malfunctions in the scope `malfunctions`; values are reals in the scope of the plant. A comment lists the
/// identifiers of symbols whose bits have a sign.
std::string vcd_header(const PlantNames& names);

}  // namespace symplant::trace
