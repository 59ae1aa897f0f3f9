// The program's options.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The planted bug that is on (planted_bugs.cmake), in programs that contain them; 0: none. `--bug` sets it.
extern int planted_bug;

namespace symplant::property {

struct Options {
  std::uint64_t plants = 2000;
  std::uint64_t seed = 1;  ///< of the first plant; later plants count up
  long minimum = 0;        ///< fail if something happened less often
  std::string fixtures;    ///< a folder for the shrunk cases; empty: do not write cases
  bool quiet = false;      ///< no table
  bool values = true;      ///< some plants have values and signals
  bool wrong = false;      ///< succeed at the first difference, fail without a difference
  std::string replay;      ///< a case, or a folder of cases, instead of random ones
  bool print = false;      ///< only print the case of `seed`
  std::string tool;        ///< of property_files: the program `symplant`, for some of the plants
};

/// Nothing, with the usage on std::cerr, if an argument is invalid.
std::optional<Options> read_options(const std::vector<std::string>& arguments);

}  // namespace symplant::property
