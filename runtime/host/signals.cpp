// The signals that a run handles.
#include "symplant/host/signals.hpp"

#include <csignal>

namespace symplant::host {
namespace {

std::atomic<bool> stop{false};
std::atomic<bool> status_asked{false};
std::atomic<int> wishes{0};
static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<int>::is_always_lock_free);  // required in a signal handler

[[maybe_unused]] void hang_up(int) { stop.store(true); }
void request_stop(int signal) {
  std::signal(signal, request_stop);  // Windows handles a signal once
  wishes.fetch_add(1);
  stop.store(true);
}
[[maybe_unused]] void request_status(int) { status_asked.store(true); }

}  // namespace

void catch_signals() {
  stop.store(false);
  wishes.store(0);
  status_asked.store(false);
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
#ifdef SIGHUP
  if (std::signal(SIGHUP, hang_up) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
#endif
#ifdef SIGUSR1
  std::signal(SIGUSR1, request_status);
#endif
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);  // the write fails, as on a full disk
#endif
}

const std::atomic<bool>& stop_requested() { return stop; }

int stop_wishes() { return wishes.load(); }

bool take_status_request() { return status_asked.exchange(false); }

}  // namespace symplant::host
