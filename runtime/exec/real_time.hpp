// A thread made fit for the cycle: priority, processor, memory, timers.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace symplant::exec {

/// What is asked for beside what every cycle gets.
struct RealTimeOptions {
  std::optional<int> priority = {};  ///< of SCHED_FIFO, 1 to 99
  std::optional<int> cpu = {};       ///< the processor to stay on, from 0
  bool lock_memory = false;          ///< no page is taken away

  bool any() const noexcept { return priority || cpu || lock_memory; }
};

/// What the system would not give.
struct Refusal {
  std::string option;   ///< "priority", "cpu", "lock-memory"
  std::string message;  ///< what was refused, why, what that means, what to do
};

/// Makes the calling thread ready for a cycle: its timers are exact to a nanosecond instead of 50 us, its stack and
/// the program's memory as far as it is there are touched, and it gets what is asked for, or a refusal for each that
/// it does not get. To be called when all other threads have begun: they keep their own priority and processor. Memory
/// that is taken later is not locked, so that a limit can never make a later allocation or thread fail.
std::vector<Refusal> set_up_real_time(const RealTimeOptions& options);

}  // namespace symplant::exec
