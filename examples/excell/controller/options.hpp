// The controller's command line.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace excell {

struct Options {
  std::string host = "127.0.0.1";
  std::string port;
  unsigned cycles = 0;  ///< 0: without end
  std::chrono::milliseconds scan{10};
  std::chrono::milliseconds connect_timeout{5'000};
  std::chrono::milliseconds step_timeout{10'000};
  bool help = false;
};

extern const char* const kUsage;

/// The options of the command line. Nothing, and the reason in `error`, if the command line is invalid.
std::optional<Options> parse_options(int argc, const char* const* argv, std::string& error);

}  // namespace excell
