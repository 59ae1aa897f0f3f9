// Keeps signals from a new thread.
#pragma once

#include <pthread.h>
#include <signal.h>

namespace symplant::link::net {

/// While it lives, every signal is blocked in this thread. A thread that is started meanwhile inherits this, so that
/// the host's threads get all signals.
class NoSignals {
 public:
  NoSignals() noexcept {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

}  // namespace symplant::link::net
