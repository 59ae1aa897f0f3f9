// A progress line on a terminal.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

namespace symplant::app {

/// Shows the current stage after the first second; shows nothing without a terminal.
class Progress {
 public:
  Progress(std::ostream& err, bool terminal);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& what);
  /// Removes the line, before something else is written to the terminal.
  void clear();

 private:
  std::ostream& err_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace symplant::app
