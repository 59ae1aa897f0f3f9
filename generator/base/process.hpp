// Runs other programs, behind an interface that tests can replace.
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
    absent,     ///< the program was not found on the path
    too_slow,   ///< it was ended after its time limit
    too_large,  ///< its output exceeded the limit
    failed,     ///< it could not be started, or its exit code was not 0
  };
  Kind kind = Kind::failed;
  std::string message;
};

struct ProcessCall {
  std::string program;                 ///< a name that is searched for on the path
  std::vector<std::string> arguments;  ///< passed as they are, without a shell
  std::string_view input = {};         ///< the standard input of the program
  std::chrono::milliseconds limit{8'000};
  std::size_t most_output = std::size_t{64} << 20;  ///< bytes
};

class ProcessRunner {
 public:
  virtual ~ProcessRunner() = default;
  /// Runs a program to its end and returns its standard output; discards its standard error.
  virtual Result<std::string, ProcessError> run(const ProcessCall& call) = 0;
};

/// Runs programs of the machine. Not thread-safe.
class SystemProcessRunner final : public ProcessRunner {
 public:
  Result<std::string, ProcessError> run(const ProcessCall& call) override;
};

}  // namespace symplant::base
