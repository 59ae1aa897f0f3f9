// --rt-check: runs cycles of the plant under the real-time guard.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "symplant/exec/guard/guard.hpp"
#include "symplant/exec/thread_faults.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// The plant time after `options.rt_check` cycles.
tables::Time end_of_rt_check(tables::Time begin, const RunOptions& options);

/// Reports on `out` what the guard found in `cycles` cycles. Returns whether it found nothing.
bool report_rt_check(const exec::GuardReport& report, const exec::ThreadFaults& faults, std::uint64_t cycles,
                     const Stage& stage, std::ostream& out);

/// Reports on `out` how many of `options.rt_check` cycles a run of `cycles` cycles lacks, and why. Returns whether any
/// cycle is missing.
bool report_missing_cycles(std::uint64_t cycles, const RunOptions& options, std::ostream& out);

/// Runs `options.rt_check` cycles on a separate thread as fast as possible, and checks what links, plant, behaviors and
/// scenario do in them. The stage's plant must be made of exec::WatchedBehaviours. Reports on `out`; returns whether
/// nothing was found and no cycle is missing.
bool run_rt_check(Stage& stage, const RunOptions& options, const Links& links, std::ostream& out);

}  // namespace symplant::host
