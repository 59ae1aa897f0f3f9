// Ends a run that does not end after a signal.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace symplant::host {

/// From construction to destruction it checks, on its own thread, whether the run ends after a signal. If it does not,
/// the process ends at once with kEnvironment and a message:
///
/// - 0.5 s after the signal, if an output is blocked: a pipe whose reader has stopped, a terminal stopped by Ctrl-S;
/// - 0.5 s after the signal, if the run has not begun: it waits for the reader of a FIFO or for a name server;
/// - at a second SIGINT or SIGTERM, 0.2 s or more after the first.
///
/// Data already written to files stays. A run that is slow for another reason, such as a busy disk, is not ended.
class LastResort {
 public:
  LastResort();
  LastResort(const LastResort&) = delete;
  LastResort& operator=(const LastResort&) = delete;
  ~LastResort();

  /// All files and links are open: from now on only a blocked output or a second signal ends the process.
  void begun() { begun_.store(true); }

 private:
  void look(const std::stop_token& done);

  std::atomic<bool> begun_{false};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

}  // namespace symplant::host
