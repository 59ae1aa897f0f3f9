// A thread made fit for the cycle: priority, processor, memory, timers.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace symplant::exec {

/// What is asked for beside what every cycle gets.
struct RealTimeOptions {
  std::optional<int> priority = {};  ///< of SCHED_FIFO, 1 to 99
  std::optional<int> cpu = {};       ///< the processor to stay on, from 0
  bool lock_memory = false;          ///< no page is taken away
  bool stay_awake = false;           ///< processors enter no idle state that takes time to leave

  bool any() const noexcept { return priority || cpu || lock_memory || stay_awake; }
};

/// What the system would not give.
struct Refusal {
  std::string option;   ///< "priority", "cpu", "lock-memory", "stay-awake"
  std::string message;  ///< what was refused, why, what that means, what to do
};

struct CloseFile {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

struct RealTimeSetup {
  std::vector<Refusal> refused;
  /// While it is open the processors stay awake; null where that was not asked for, or refused.
  std::unique_ptr<std::FILE, CloseFile> awake = {};
};

/// Makes the calling thread ready for a cycle: its timers are exact to a nanosecond instead of 50 us, its stack and
/// the program's memory as far as it is there are touched, and it gets what is asked for, or a refusal for each that
/// it does not get. To be called when all other threads have begun: they keep their own priority and processor. Memory
/// that is taken later is not locked, so that a limit can never make a later allocation or thread fail. To stay awake
/// is asked of the kernel's power management (PM QoS, a latency of 0 us) for the whole machine, as long as the result
/// lives.
RealTimeSetup set_up_real_time(const RealTimeOptions& options);

}  // namespace symplant::exec
