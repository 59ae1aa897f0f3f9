// What the program is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace symplant::property {

struct Options {
  std::uint64_t plants = 2000;
  std::uint64_t seed = 1;  ///< of the first plant; the others follow
  long minimum = 0;        ///< fail where something happened less often
  std::string fixtures;    ///< a folder for the shrunk cases; empty: none are written
  bool quiet = false;      ///< no table
  bool wrong = false;      ///< succeed at the first disagreement, fail where there is none
  std::string replay;      ///< a case, or a folder of such, instead of random ones
  bool print = false;      ///< only print the case of `seed`
  std::string tool;        ///< of property_files: the program `symplant`, for some of the plants
};

/// Nothing, and the usage on std::cerr, where an argument is not understood.
std::optional<Options> read_options(const std::vector<std::string>& arguments);

}  // namespace symplant::property
