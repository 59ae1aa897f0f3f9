// Runs another program within limits and measures it.
#pragma once

#include <string>
#include <vector>

namespace symplant::hostile {

struct Run {
  int code = -1;   ///< its exit code; -1: a signal ended it
  int signal = 0;  ///< that signal
  double cpu_seconds = 0;
  long peak_kilobytes = 0;
  std::string out;  ///< the beginning of its output
  std::string err;
  bool ill_formed = false;       ///< it wrote ASCII control characters, or invalid UTF-8
  bool steers_terminal = false;  ///< it wrote control characters outside ASCII
};

/// Runs a program in `folder`, with standard output and error stored in files of `scratch`. Ends it after 120 s, or
/// 100 s of processor time.
Run run(const std::vector<std::string>& arguments, const std::string& folder, const std::string& scratch);

/// Limits the address space of all later programs, so that a faulty one cannot exhaust the machine's memory.
/// Not for programs under sanitizers, which need much address space.
void limit_address_space(long kilobytes);

}  // namespace symplant::hostile
