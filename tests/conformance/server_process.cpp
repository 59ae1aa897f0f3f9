// A server under test in a separate process.
#include "server_process.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <sstream>
#include <stdexcept>

namespace symplant::conformance {

ServerProcess::ServerProcess(const std::string& command) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  pid_ = ::fork();
  if (pid_ == 0) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a server ends with the runner that started it
    ::dup2(ends[1], 1);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
    ::_exit(127);
  }
  ::close(ends[1]);
  std::string line;
  for (char c = 0; ::read(ends[0], &c, 1) == 1 && c != '\n';) line += c;
  ::close(ends[0]);
  std::istringstream stream(line);
  stream >> server_.port;
  for (std::uint32_t& size : server_.sizes) stream >> size;
  stream >> std::ws;
  std::getline(stream, version_);
  if (version_.empty()) throw std::runtime_error("`" + command + "` does not say what it serves: `" + line + "`");
}

ServerProcess::~ServerProcess() {
  ::kill(-pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

}  // namespace symplant::conformance
