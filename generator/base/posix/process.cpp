// Other programs by posix_spawn: pipes, a time limit, no shell.
#include "base/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <thread>

#include "base/descriptor.hpp"

namespace symplant::base {
namespace {

using Clock = std::chrono::steady_clock;
using Kind = ProcessError::Kind;

ProcessError failure(Kind kind, const ProcessCall& call, const std::string& what) {
  return {kind, "`" + call.program + "` " + what};
}

/// One run of a program. The destructor ends the program if it still runs.
class Child {
 public:
  explicit Child(const ProcessCall& call) : call_(call), deadline_(Clock::now() + call.limit) {}
  ~Child() {
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::optional<ProcessError> start() {
    std::array<int, 2> in{};
    std::array<int, 2> out{};
    // A socket: writing to a pipe without a reader would end this program by a signal.
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in.data()) != 0) return error_of("has no input", errno);
    const Descriptor child_in(in[0]);
    in_ = Descriptor(in[1]);
    if (::pipe2(out.data(), O_CLOEXEC) != 0) return error_of("has no output", errno);
    const Descriptor child_out(out[1]);
    out_ = Descriptor(out[0]);
    ::fcntl(in_.number(), F_SETFL, O_NONBLOCK);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, child_in.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, child_out.number(), STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::vector<char*> arguments{const_cast<char*>(call_.program.c_str())};  // posix_spawn's own signature
    for (const std::string& argument : call_.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    pid_t pid = -1;
    const int fault = ::posix_spawnp(&pid, call_.program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (fault == ENOENT) return failure(Kind::absent, call_, "is not on the path");
    if (fault != 0) return error_of("could not be started", fault);
    pid_ = pid;
    return std::nullopt;
  }

  Result<std::string, ProcessError> finish() {
    std::string output;
    if (auto error = exchange(output)) return *error;
    int status = 0;
    while (::waitpid(pid_, &status, WNOHANG) == 0) {
      if (Clock::now() >= deadline_) return too_slow();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    pid_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return output;
    if (WIFEXITED(status)) {
      // Exit code 127: the program could not be executed, as in a shell.
      const int code = WEXITSTATUS(status);
      return failure(code == 127 ? Kind::absent : Kind::failed, call_, "ended with code " + std::to_string(code));
    }
    return failure(Kind::failed, call_, "was ended by signal " + std::to_string(WTERMSIG(status)));
  }

 private:
  ProcessError error_of(const std::string& what, int fault) const {
    return failure(Kind::failed, call_, what + ": " + std::strerror(fault));
  }
  ProcessError too_slow() const {
    return failure(Kind::too_slow, call_, "took more than " + std::to_string(call_.limit.count()) + " ms");
  }

  /// Writes the input and reads the output until the program closes its output.
  std::optional<ProcessError> exchange(std::string& output) {
    std::string_view rest = call_.input;
    if (rest.empty()) in_.close();
    std::array<char, 65'536> buffer{};
    while (true) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
      if (left <= 0) return too_slow();
      std::array<pollfd, 2> waiting{pollfd{out_.number(), POLLIN, 0}, pollfd{in_.number(), POLLOUT, 0}};
      const int ready = ::poll(waiting.data(), waiting.size(), static_cast<int>(left));
      if (ready < 0 && errno != EINTR) return error_of("could not be waited for", errno);
      if (ready <= 0) continue;
      if (waiting[1].revents != 0 && in_.number() >= 0) {
        const ssize_t sent = ::send(in_.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent > 0) rest.remove_prefix(static_cast<std::size_t>(sent));
        if (rest.empty() || (sent < 0 && errno != EAGAIN && errno != EINTR)) in_.close();
      }
      if (waiting[0].revents == 0) continue;
      const ssize_t got = ::read(out_.number(), buffer.data(), buffer.size());
      if (got == 0) return std::nullopt;
      if (got < 0 && errno != EINTR) return error_of("could not be read from", errno);
      if (got > 0) output.append(buffer.data(), static_cast<std::size_t>(got));
      if (output.size() > call_.most_output) return failure(Kind::too_large, call_, "wrote too much");
    }
  }

  const ProcessCall& call_;
  const Clock::time_point deadline_;
  Descriptor in_;
  Descriptor out_;
  pid_t pid_ = -1;
};

}  // namespace

Result<std::string, ProcessError> SystemProcessRunner::run(const ProcessCall& call) {
  Child child(call);
  if (auto error = child.start()) return *error;
  return child.finish();
}

}  // namespace symplant::base
