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

/// Use in this order: constructor (sets up the thread), go(), join().
class CycleThread {
 public:
  /// The thread runs `cycles` after go(); if `guarded`, under the trap of the guard.
  CycleThread(const exec::RealTimeOptions& options, std::function<void()> cycles, bool guarded);
  CycleThread(const CycleThread&) = delete;
  CycleThread& operator=(const CycleThread&) = delete;
  /// Ends the thread without cycles if go() was not called.
  ~CycleThread();

  /// The real-time settings that the system refused. Waits until the setup is done; call it only once.
  std::vector<exec::Refusal> refused() { return refused_.get(); }
  void go() { go_.set_value(true); }
  void join() { thread_.join(); }

  // --- after join()

  const exec::ThreadFaults& faults() const { return faults_; }  ///< during the cycles
  const exec::GuardReport& report() const { return report_; }   ///< if it was guarded

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
