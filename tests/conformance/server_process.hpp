// A server under test in a separate process.
#pragma once

#include <sys/types.h>

#include <string>

#include "player.hpp"

namespace symplant::conformance {

/// Runs a command whose first line is `PORT COILS DISCRETE_INPUTS HOLDING INPUT VERSION`; its destructor ends it.
class ServerProcess {
 public:
  /// Throws std::runtime_error if the command does not print such a line.
  explicit ServerProcess(const std::string& command);
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  const Server& server() const { return server_; }
  const std::string& version() const { return version_; }

 private:
  pid_t pid_ = -1;
  Server server_;
  std::string version_;
};

}  // namespace symplant::conformance
