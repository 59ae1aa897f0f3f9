// The signals that end a run.
#include "symplant/host/signals.hpp"

#include <csignal>

namespace symplant::host {
namespace {

std::atomic<bool> stop{false};

void request_stop(int) { stop.store(true); }

}  // namespace

void catch_signals() {
  stop.store(false);
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
}

const std::atomic<bool>& stop_requested() { return stop; }

}  // namespace symplant::host
