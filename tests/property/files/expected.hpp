// What the reference says that a run of the tool must write.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

struct Outcome {
  int code = 0;
  std::string header;                 ///< of the trace; empty: not looked at
  std::vector<std::string> trace;     ///< lines behind the header
  std::vector<std::string> findings;  ///< how each line begins
  std::vector<std::string>
      verdicts;  ///< "step 3 held", "requirement: r1 failed": steps that expect or wait, then requirements
};

/// Nothing where the case is none: a faulty plant, a step that names what is not there, too many instants.
std::optional<Outcome> expected(const FileCase& it, Counts& counts);

/// The files of a case, which must be one.
Files files_of(const FileCase& it, Counts& counts);

}  // namespace symplant::property::files
