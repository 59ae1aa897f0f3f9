// Keeps signals from a new thread.
#pragma once

#ifndef _WIN32
#include <pthread.h>
#include <signal.h>
#endif

namespace symplant::link::net {

/// While it lives, every signal is blocked in this thread. A thread that is started meanwhile inherits this, so that
/// the host's threads get all signals. Windows gives signals a thread anyway.
class NoSignals {
 public:
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;

#ifdef _WIN32
  NoSignals() noexcept {}  // NOLINT(modernize-use-equals-default): a trivial class would give unused-variable warnings
  ~NoSignals() {}          // NOLINT(modernize-use-equals-default)
#else
  NoSignals() noexcept {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
#endif
};

}  // namespace symplant::link::net
