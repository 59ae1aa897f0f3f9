// Other programs as a parameter: the tool's are the machine's, a test's are invented.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace symplant::base {

/// Why a program gave no output.
struct ProcessError {
  enum class Kind {
    absent,     ///< there is no such program on the path
    too_slow,   ///< it was ended at its time limit
    too_large,  ///< its output was more than the limit
    failed,     ///< it could not be started, or its exit code was not 0
  };
  Kind kind = Kind::failed;
  std::string message;
};

struct ProcessCall {
  std::string program;                 ///< a name looked for on the path
  std::vector<std::string> arguments;  ///< as they are: no shell sees them
  std::string_view input = {};         ///< what its standard input holds
  std::chrono::milliseconds limit{8'000};
  std::size_t most_output = std::size_t{64} << 20;  ///< bytes
};

class ProcessRunner {
 public:
  virtual ~ProcessRunner() = default;
  /// Runs a program to its end and gives its standard output; its standard error goes nowhere.
  virtual Result<std::string, ProcessError> run(const ProcessCall& call) = 0;
};

/// The machine's own programs. Not to be used by two threads at once.
class SystemProcessRunner final : public ProcessRunner {
 public:
  Result<std::string, ProcessError> run(const ProcessCall& call) override;
};

}  // namespace symplant::base
