// naming.json: a naming rule as a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/description.hpp"
#include "name/naming.hpp"
#include "symplant/json/location.hpp"

namespace symplant::naming {

struct NamingReading {
  /// The readable part, even with faults; nothing if it is not a naming rule of this version.
  std::optional<name::Naming> naming;
  std::string links_file;                             ///< as written; empty: the links are in `naming`, or missing
  std::vector<json::Placed> syntax;                   ///< faults of the JSON syntax
  std::vector<description::DescriptionFault> faults;  ///< of the form, and contradictions
};

/// Reads the text of a naming.json. Patterns and regular expressions are not examined here but by
/// name::CompiledNaming. O(text).
NamingReading read_naming(std::string_view text);

/// Reads a naming rule that is a value in another file: its JSON text, in which the version may be missing. All
/// pointers of faults begin with `base`.
NamingReading read_inline_naming(std::string_view text, std::string_view base);

/// The schema of naming.json, as `symplant schema naming` prints it.
std::string_view naming_schema();

}  // namespace symplant::naming
