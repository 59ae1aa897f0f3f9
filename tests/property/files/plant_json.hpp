// plant.json of a random plant.
#pragma once

#include <array>
#include <string>

#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// The plant as a file can express it: inputs and outputs in the order of their names, no time after the last one
/// that can be written; sometimes a behavior that the tool does not have, or a second list.
void make_sayable(PlantText& plant, std::uint64_t seed);

/// plant.json; the lists must be in the same folder under the names `kListNames`.
std::string plant_json(const PlantText& plant, const Style& style, Counts& counts);

inline constexpr std::array<const char*, 2> kListNames = {"list.csv", "second.csv"};

}  // namespace symplant::property::files
