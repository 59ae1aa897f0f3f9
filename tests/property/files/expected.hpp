// The output that a run of the tool must write, according to the reference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

struct Outcome {
  int code = 0;
  std::string header;                 ///< of the trace; empty: not compared
  std::vector<std::string> trace;     ///< lines after the header
  std::vector<std::string> findings;  ///< the beginning of each line
  std::vector<std::string> verdicts;  ///< "step 3 held", "requirement: r1 failed": steps that expect or wait or have
                                      ///< failed, then requirements
};

/// Nothing if the case is invalid: a faulty plant, a step with unknown names, too many instants.
std::optional<Outcome> expected(const FileCase& it, Counts& counts);

/// The files of a valid case.
Files files_of(const FileCase& it, Counts& counts);

}  // namespace symplant::property::files
