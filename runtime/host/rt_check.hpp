// --rt-check: cycles of the plant under the guard of real time.
#pragma once

#include <iosfwd>

#include "symplant/exec/cycle.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

struct RtChecked {
  exec::CycleStatistics cycles;
  bool clean = false;  ///< nothing was done that a cycle must not do, as far as could be looked at
};

/// Runs `options.rt_check` cycles on a thread of their own, in real time or as fast as it goes, and looks at what the
/// plant, its behaviours and its scenario do in them. The stage's plant is made of exec::WatchedBehaviours. Tells on
/// `out` what was found.
RtChecked run_rt_check(Stage& stage, const RunOptions& options, const Links& links, bool real, std::ostream& out);

}  // namespace symplant::host
