// Ends a run that does not end after a signal.
#include "symplant/host/last_resort.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string_view>

#include "symplant/exec/guard/thread_sanitizer.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"

namespace symplant::host {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kLook{100};
constexpr milliseconds kSameWish{200};  ///< a closed terminal may send its signal twice
constexpr milliseconds kPatience{500};
constexpr int kLooks = 3;       ///< a slow reader takes something in between
constexpr int kMostFiles = 64;  ///< outputs are opened first

/// Whether a pipe or a terminal that this process writes to is full.
bool output_is_not_taken() {
  const exec::guard::UnwatchedReads other_threads_may_open_and_close_files;
  for (int file = STDOUT_FILENO; file < kMostFiles; ++file) {
    struct stat kind {};
    if (fstat(file, &kind) != 0) continue;
    const int mode = fcntl(file, F_GETFL);
    if (mode < 0 || (mode & O_ACCMODE) == O_RDONLY) continue;
    if (!S_ISFIFO(kind.st_mode) && isatty(file) == 0) continue;
    pollfd asked{file, POLLOUT, 0};
    if (poll(&asked, 1, 0) == 0) return true;
  }
  return false;
}

[[noreturn]] void end_at_once(std::string_view why) {
  pollfd asked{STDERR_FILENO, POLLOUT, 0};
  if (poll(&asked, 1, 0) == 1 && ::write(STDERR_FILENO, why.data(), why.size()) < 0) std::_Exit(kEnvironment);
  std::_Exit(kEnvironment);
}

}  // namespace

LastResort::LastResort() {
  thread_ = std::jthread([this](const std::stop_token& done) { look(done); });
}

LastResort::~LastResort() {
  thread_.request_stop();
  thread_.join();
}

void LastResort::look(const std::stop_token& done) {
  std::unique_lock lock(mutex_);
  const auto wait = [&] { wake_.wait_for(lock, done, kLook, [] { return false; }); };
  while (!done.stop_requested() && !stop_requested().load()) wait();
  const Clock::time_point reported = Clock::now();
  int wishes = 0;
  int not_taken = 0;  // looks in a row
  for (; !done.stop_requested(); wait()) {
    const auto since = Clock::now() - reported;
    if (since < kSameWish) {
      wishes = stop_wishes();
    } else if (stop_wishes() != wishes) {
      end_at_once("error: ended at once by a second signal; outputs may be incomplete\n");
    }
    not_taken = output_is_not_taken() ? not_taken + 1 : 0;
    if (since < kPatience) continue;
    if (!begun_.load()) end_at_once("error: ended by a signal before the run began\n");
    if (not_taken >= kLooks) {
      end_at_once("error: ended by a signal while an output was blocked; outputs may be incomplete\n");
    }
  }
}

}  // namespace symplant::host
