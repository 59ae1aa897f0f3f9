// Counts what random files held, and what happened in their runs.
#pragma once

#include <ostream>

#include "property/files/expected.hpp"

namespace symplant::property::files {

struct FilesTally {
  long plants = 0;
  long left_aside = 0;  ///< invalid cases: too many instants
  long by_program = 0;
  long steps = 0;
  long trace_lines = 0;
  long finding_lines = 0;
  Counts counts;

  void add(const FileCase& it, const Outcome& outcome);
  void print(std::ostream& out, double seconds) const;
  /// Whether something happened less often than `minimum`; prints it.
  bool missed(std::ostream& out, long minimum) const;
};

}  // namespace symplant::property::files
