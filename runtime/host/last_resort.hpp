// A run that was told to end and cannot.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace symplant::host {

/// From its making to its end it looks, on a thread of its own, whether a run that a signal ended does end. Where it
/// does not, it ends the process on the spot with kEnvironment and says why:
///
/// - half a second after the signal, where what the run writes is not taken: by a pipe whose reader stands still, a
///   terminal stopped by Ctrl-S;
/// - half a second after the signal, where the run has not begun: it waits for the reader of a FIFO or a name server;
/// - at a second SIGINT or SIGTERM, a fifth of a second or more after the first.
///
/// What was written to files stays. A run that is slow for another reason, such as a busy disk, is given its time.
class LastResort {
 public:
  LastResort();
  LastResort(const LastResort&) = delete;
  LastResort& operator=(const LastResort&) = delete;
  ~LastResort();

  /// All is open: from now on only what is not taken or a second signal ends it.
  void begun() { begun_.store(true); }

 private:
  void look(const std::stop_token& done);

  std::atomic<bool> begun_{false};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

}  // namespace symplant::host
