// The real-time cycle: links and plant, once a cycle, on absolute deadlines.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "symplant/exec/clock.hpp"
#include "symplant/exec/cycle_meter.hpp"
#include "symplant/exec/exchange.hpp"
#include "symplant/exec/stepper.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::exec {

struct CycleOptions {
  tables::Time cycle = 10 * tables::kMillisecond;  ///< from deadline to deadline, > 0
  tables::Time until = tables::kNever;             ///< plant time of the last cycle, which may be a shorter one
  std::int64_t max_catch_up = 10;                  ///< cycles run at once after a delay; what is beyond is slipped
  tables::Time spin = 0;  ///< so long before a deadline the thread stays awake and looks at the clock, below `cycle`
};

/// Runs the plant in real time from where it stands until `stop` or the end of `options.until`.
///
/// First the plant's instant at its present time is run and every link gets its events. Then each cycle, at plant
/// time T: every link's operations are read, the plant is advanced to T, every link gets the events, and the plant
/// forgets which had changed. T grows by `options.cycle`, in step with the clock. A cycle that is late is run all the
/// same, at once and for its own T, so the plant catches up in order; when more than `max_catch_up` cycles are due
/// at once beside the present one, the time of the others is slipped.
///
/// While a link freezes the plant cycles go on with links alone; plant time stands still and is not caught up.
///
/// With a `stepper` it is that which advances the plant, and the run ends with the cycle in which it is over unless
/// `options.until` says when. `stop` may be set by any thread or a signal handler and is seen within a tenth of a
/// second. Takes no heap and no lock; its only system calls are the clock's. All of it but the links' leave() is
/// guarded (guard/guard.hpp), so a thread under the guard's trap finds out whether that holds.
///
/// `meter` is added to, and may be read meanwhile by any thread.
void run_cycles(plant::Plant& plant, std::span<Exchange* const> links, const CycleOptions& options, Clock& clock,
                CycleMeter& meter, const std::atomic<bool>& stop, engine::Observer* observer = nullptr,
                Stepper* stepper = nullptr) noexcept;

}  // namespace symplant::exec
