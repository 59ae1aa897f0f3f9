// Prints the table at the end of a run.
#include "property/files/files_tally.hpp"

#include <iomanip>

namespace symplant::property::files {

void FilesTally::add(const FileCase& it, const Outcome& outcome) {
  ++plants;
  steps += std::ssize(it.steps);
  trace_lines += std::ssize(outcome.trace);
  finding_lines += std::ssize(outcome.findings);
}

void FilesTally::print(std::ostream& out, double seconds) const {
  out << plants << " plants from files in " << std::fixed << std::setprecision(1) << seconds << " s, " << by_program
      << " of them by the program; " << left_aside << " left aside; " << steps << " steps, " << trace_lines
      << " trace lines, " << finding_lines << " findings\n";
  for (std::size_t i = 0; i < kSeen; ++i)
    out << "  " << std::setw(9) << counts.counts[i] << "  " << kSeenNames[i] << "\n";
}

bool FilesTally::missed(std::ostream& out, long minimum) const {
  bool any = false;
  for (std::size_t i = 0; i < kSeen; ++i) {
    if (counts.counts[i] >= minimum) continue;
    out << "only " << counts.counts[i] << " times: " << kSeenNames[i] << "\n";
    any = true;
  }
  return any;
}

}  // namespace symplant::property::files
