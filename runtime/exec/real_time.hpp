// Prepares a thread for the real-time cycle: priority, processor, memory, timers.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace symplant::exec {

/// Optional real-time settings.
struct RealTimeOptions {
  std::optional<int> priority = {};  ///< of SCHED_FIFO, 1 to 99
  std::optional<int> cpu = {};       ///< the processor to run on, from 0
  bool lock_memory = false;          ///< keep all pages in memory
  bool stay_awake = false;           ///< keep processors out of idle states from which they wake late

  bool any() const noexcept { return priority || cpu || lock_memory || stay_awake; }
};

/// A setting that the system refused.
struct Refusal {
  std::string option;   ///< "priority", "cpu", "lock-memory", "stay-awake"
  std::string message;  ///< what was refused, why, the effect, and what to do
};

struct CloseFile {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

struct RealTimeSetup {
  std::vector<Refusal> refused;
  /// While it is open the processors stay awake; null if that was not requested, or refused.
  std::unique_ptr<std::FILE, CloseFile> awake = {};
};

/// Prepares the calling thread for a cycle: sets its timer slack to 1 ns instead of 50 us, touches its stack and
/// populates the program's memory, and applies `options`. Each option that fails gives a Refusal. Call it after all
/// other threads have started: they keep their priority and processor. Memory allocated later is not locked, so that a
/// limit cannot make a later allocation or thread fail. `stay_awake` requests a latency of 0 us from the kernel's power
/// management (PM QoS) for the whole machine, for the lifetime of the result.
RealTimeSetup set_up_real_time(const RealTimeOptions& options);

}  // namespace symplant::exec
