// A file with a list of malfunctions, as plant.json has them.
#pragma once

#include <string_view>
#include <vector>

#include "description/description.hpp"
#include "symplant/json/location.hpp"

namespace symplant::description {

struct MalfunctionsReading {
  std::vector<GivenMalfunction> malfunctions;
  std::vector<json::Placed> syntax;      ///< faults of the JSON syntax
  std::vector<DescriptionFault> faults;  ///< where it does not fit the format; pointers into this file
};

/// Reads the text of such a file. Names are not resolved. O(text).
MalfunctionsReading read_malfunctions(std::string_view text);

/// The pointer of a malfunction of such a file, from that in the description to which the file's were added after
/// `own` others: `/malfunctions/5/of` with `own` 3 is `/2/of`. Empty for any other pointer.
std::string pointer_in_file(std::string_view pointer, std::size_t own);

}  // namespace symplant::description
