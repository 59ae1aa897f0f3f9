// The thread of the cycle in real time.
#pragma once

#include <functional>
#include <future>
#include <thread>
#include <vector>

#include "symplant/exec/guard/guard.hpp"
#include "symplant/exec/real_time.hpp"
#include "symplant/exec/thread_faults.hpp"

namespace symplant::host {

/// Set up first, then told to go, then waited for.
class CycleThread {
 public:
  /// `cycles` is run on the thread, behind go(); with `guarded` under the guard's trap.
  CycleThread(const exec::RealTimeOptions& options, std::function<void()> cycles, bool guarded);
  CycleThread(const CycleThread&) = delete;
  CycleThread& operator=(const CycleThread&) = delete;
  /// Lets go of a thread that was never told to.
  ~CycleThread();

  /// What the system would not give, as soon as it is known.
  std::vector<exec::Refusal> refused() { return refused_.get(); }
  void go() { go_.set_value(true); }
  void join() { thread_.join(); }

  // --- behind join()

  const exec::ThreadFaults& faults() const { return faults_; }  ///< in the cycles
  const exec::GuardReport& report() const { return report_; }   ///< where it was guarded

 private:
  void run(const exec::RealTimeOptions& options, const std::function<void()>& cycles, bool guarded);

  std::promise<std::vector<exec::Refusal>> set_up_;
  std::future<std::vector<exec::Refusal>> refused_ = set_up_.get_future();
  std::promise<bool> go_;
  exec::ThreadFaults faults_;
  exec::GuardReport report_;
  std::thread thread_;
};

}  // namespace symplant::host
