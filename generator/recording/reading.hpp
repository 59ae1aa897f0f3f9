// What the readers of all formats take and return.
#pragma once

#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "recording/renames.hpp"

namespace symplant::recording {

/// How files of other tools are read. Traces of symplant need none of it.
struct ReadOptions {
  std::string time_column;  ///< the name of the column of times; empty: by its header
  std::string time_unit;    ///< s, ms, us, ns, filetime or iso; empty: by the header or the cells
  Renames renames;
};

/// What was read, or why it could not be.
struct ReadRecording {
  Recording recording;
  std::string error;                  ///< `FILE:4: ...`; empty: the whole file could be read
  std::vector<std::string> warnings;  ///< as error: what was left out
  std::vector<std::string> names;     ///< of symbols in the file, before ReadOptions::renames; empty without these
};

}  // namespace symplant::recording
