// Another program, run within limits and measured.
#pragma once

#include <string>
#include <vector>

namespace symplant::hostile {

struct Run {
  int code = -1;   ///< its exit code; -1: a signal ended it
  int signal = 0;  ///< that signal
  double cpu_seconds = 0;
  long peak_kilobytes = 0;
  std::string out;  ///< the beginning of what it wrote
  std::string err;
  bool ill_formed = false;       ///< it wrote ASCII control characters, or bytes that are no UTF-8
  bool steers_terminal = false;  ///< it wrote control characters beyond ASCII
};

/// Runs a program in `folder`, with standard output and error kept in files of `scratch`. It is ended after 120 s, or
/// 100 s of processor time.
Run run(const std::vector<std::string>& arguments, const std::string& folder, const std::string& scratch);

/// From now on a program gets no more address space than that, so that a faulty one does not take the whole machine.
/// Not for programs under sanitizers, which take much.
void limit_address_space(long kilobytes);

}  // namespace symplant::hostile
