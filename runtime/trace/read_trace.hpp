// Reads a trace file back into records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::trace {

/// What a trace holds since the plant was set to another state for the last time.
struct ReadTrace {
  std::vector<Record> records;  ///< in the order of the file, ends of instants marked
  std::string model_hash;       ///< of its header
  tables::Time begin = 0;       ///< the time of its first values
  tables::Time end = 0;         ///< the time of its last line
  std::size_t set_back = 0;     ///< how often the plant was reset or restored
  std::size_t unknown = 0;      ///< lines about names that the plant does not have
  std::string first_unknown;    ///< one of these names
  bool cut_off = false;         ///< the last line was cut off, and is left out
  std::string error;            ///< `line 4: ...`; empty: the whole file could be read
};

/// Reads a trace of a plant with these names. O(file * log(names)).
ReadTrace read_trace(std::istream& file, const PlantNames& names);

}  // namespace symplant::trace
