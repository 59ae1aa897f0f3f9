// The thread of the cycle in real time.
#include "symplant/host/cycle_thread.hpp"

#include "symplant/exec/guard/interpose.hpp"

namespace symplant::host {

CycleThread::CycleThread(const exec::RealTimeOptions& options, std::function<void()> cycles, bool guarded) {
  if (guarded) report_.no_hooks = exec::guard::interpose();
  thread_ = std::thread([this, options, cycles = std::move(cycles), guarded] { run(options, cycles, guarded); });
}

CycleThread::~CycleThread() {
  if (!thread_.joinable()) return;
  go_.set_value(false);
  thread_.join();
}

void CycleThread::run(const exec::RealTimeOptions& options, const std::function<void()>& cycles, bool guarded) {
  std::future<bool> go = go_.get_future();
  exec::RealTimeSetup setup = exec::set_up_real_time(options);
  set_up_.set_value(std::move(setup.refused));
  if (!go.get()) return;
  const std::string no_trap = guarded ? exec::trap_system_calls() : std::string();
  const exec::ThreadFaults before = exec::thread_faults();
  cycles();
  faults_ = exec::thread_faults() - before;
  if (!guarded) return;
  const std::string no_hooks = std::move(report_.no_hooks);
  report_ = exec::take_violations();
  report_.no_hooks = no_hooks;
  report_.no_trap = no_trap;
}

}  // namespace symplant::host
