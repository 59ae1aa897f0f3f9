// Terminals and pipes by POSIX.
#include "symplant/host/terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "symplant/exec/guard/thread_sanitizer.hpp"

namespace symplant::host {
namespace {

constexpr int kMostFiles = 64;  ///< outputs are opened first

}  // namespace

bool is_terminal(Stream stream) { return isatty(static_cast<int>(stream)) != 0; }

bool can_redraw_lines() {
  const char* const kind = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): no thread sets variables
  return kind != nullptr && std::string_view(kind) != "dumb";
}

std::size_t terminal_columns() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

bool would_take(Stream stream) {
  pollfd asked{static_cast<int>(stream), POLLOUT, 0};
  return poll(&asked, 1, 0) != 0;  // poll() also reports a reader that is gone
}

bool output_is_full() {
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

void write_error_now(std::string_view text) {
  pollfd asked{STDERR_FILENO, POLLOUT, 0};
  if (poll(&asked, 1, 0) == 1 && ::write(STDERR_FILENO, text.data(), text.size()) < 0) return;
}

void set_up_streams() {}

void on_closing(void (* /*stop*/)()) {}

void end_process(int code) { std::_Exit(code); }

void restore_streams() {}

}  // namespace symplant::host
