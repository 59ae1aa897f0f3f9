// --rt-check: cycles of the plant under the guard of real time.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "symplant/exec/guard/guard.hpp"
#include "symplant/exec/thread_faults.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// Plant time at which `options.rt_check` cycles are over.
tables::Time end_of_rt_check(tables::Time begin, const RunOptions& options);

/// Tells on `out` what a guarded run of `cycles` cycles was found to do; gives whether it was nothing, as far as could
/// be looked at.
bool report_rt_check(const exec::GuardReport& report, const exec::ThreadFaults& faults, std::uint64_t cycles,
                     const Stage& stage, std::ostream& out);

/// Tells on `out` how many of `options.rt_check` cycles are missing in a run of so many, and why; whether any are.
bool report_missing_cycles(std::uint64_t cycles, const RunOptions& options, std::ostream& out);

/// Runs `options.rt_check` cycles on a thread of their own as fast as it goes, and looks at what links, plant,
/// behaviours and scenario do in them. The stage's plant is made of exec::WatchedBehaviours. Gives
/// whether nothing was found and no cycle is missing, and tells of both.
bool run_rt_check(Stage& stage, const RunOptions& options, const Links& links, std::ostream& out);

}  // namespace symplant::host
